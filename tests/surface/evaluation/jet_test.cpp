// Jets of floats are computed in registers of four (jet_lanes.h): with the bits of the formulas number by number.
#include "core/base/random.h"
#include "core/surface/evaluation/jet.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;

class JetTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void registersHoldNothingElse();
    void registersHaveTheBitsOfSingleNumbers();
};

namespace {

/// A jet number by number, with all that may be asked of it.
struct Plain {
    float v = 0, d[3] = {}, dd[3][3] = {};
};

template <int O>
Plain plainOf(const Jet<float, O>& a) {
    Plain out;
    out.v = a.v;
    for (std::size_t k = 0; k < 3; ++k)
        out.d[k] = a.d[k];
    if constexpr (O >= 2)
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                out.dd[k][l] = a.dd[static_cast<std::size_t>(sym(k, l))];
    return out;
}

template <int O>
Jet<float, O> random(base::Random& from) {
    const auto number = [&] {
        const double kind = from.uniform();
        return kind < 0.05 ? 0.0f : static_cast<float>(from.normal() * std::exp(from.uniform(-12, 12)));
    };
    Jet<float, O> out;
    out.v = number();
    for (float& each : out.d)
        each = number();
    for (float& each : out.dd)
        each = number();
    return out;
}

/// Equal, zeros of either sign being alike: what a derivative that vanishes adds has no sign to keep.
template <int O, class Value, class First, class Second>
bool same(const Jet<float, O>& found, const Value& value, const First& first, const Second& second) {
    const auto alike = [](float a, float b) { return shapes::sameBits(a, b) || (a == 0 && b == 0); };
    const Plain is = plainOf(found);
    bool good = alike(is.v, value());
    for (int k = 0; k < 3; ++k) {
        good = good && alike(is.d[k], first(k));
        if constexpr (O >= 2)
            for (int l = k; l < 3; ++l)
                good = good && alike(is.dd[k][l], second(k, l));
    }
    if constexpr (O == 2) // what fills the registers stays out of everything
        good = good && found.unused[0] == 0 && found.unused[1] == 0;
    return good;
}

template <int O>
bool registersAgree(base::Random& from) {
    const Jet<float, O> ja = random<O>(from), jb = random<O>(from);
    const Plain a = plainOf(ja), b = plainOf(jb);
    const float s = static_cast<float>(from.normal());
    const auto none = [](int, int) { return 0.0f; };
    bool good = same(
        ja + jb, [&] { return a.v + b.v; }, [&](int k) { return a.d[k] + b.d[k]; },
        [&](int k, int l) { return a.dd[k][l] + b.dd[k][l]; });
    good = good && same(
                       ja - jb, [&] { return a.v - b.v; }, [&](int k) { return a.d[k] - b.d[k]; },
                       [&](int k, int l) { return a.dd[k][l] - b.dd[k][l]; });
    good = good && same(
                       ja * s, [&] { return a.v * s; }, [&](int k) { return a.d[k] * s; },
                       [&](int k, int l) { return a.dd[k][l] * s; });
    good = good &&
           same(
               ja * jb, [&] { return a.v * b.v; }, [&](int k) { return a.d[k] * b.v + a.v * b.d[k]; },
               [&](int k, int l) { return a.dd[k][l] * b.v + a.d[k] * b.d[l] + a.d[l] * b.d[k] + a.v * b.dd[k][l]; });
    const float f[4] = {b.v, b.d[0], b.d[1], b.d[2]};
    good = good && same(
                       chain(ja, f[0], f[1], f[2], f[3]), [&] { return f[0]; }, [&](int k) { return f[1] * a.d[k]; },
                       [&](int k, int l) { return f[1] * a.dd[k][l] + f[2] * a.d[k] * a.d[l]; });
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](int k) { return k == axis ? 1.0f : 0.0f; };
        good = good && same(
                           timesCoordinate(axis, ja), [] { return 0.0f; }, [&](int k) { return at(k) * a.v; },
                           [&](int k, int l) { return at(k) * a.d[l] + at(l) * a.d[k]; });
        good = good && same(
                           coordinate<float, O>(axis), [] { return 0.0f; }, at, none);
    }
    return good && same(
                       constantJet<float, O>(s), [&] { return s; }, [](int) { return 0.0f; }, none);
}

} // namespace

void JetTest::registersHoldNothingElse() {
    QCOMPARE(sizeof(Jet<float, 0>), sizeof(float));
    QCOMPARE(sizeof(Jet<float, 1>), 4 * sizeof(float));
    QCOMPARE(sizeof(Jet<float, 2>), 12 * sizeof(float));
    QCOMPARE(sizeof(Jet<double, 1>), 4 * sizeof(double));
    QCOMPARE(alignof(Jet<float, 1>), std::size_t(16));
}

void JetTest::registersHaveTheBitsOfSingleNumbers() {
    base::Random from(test::seed());
    for (int i = 0; i < test::effort(2000); ++i)
        QVERIFY2(registersAgree<1>(from) && registersAgree<2>(from), qPrintable(QString("seed %1").arg(test::seed())));
}

static const test::Registered<JetTest> registered;
#include "jet_test.moc"
