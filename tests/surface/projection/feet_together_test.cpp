// Orthogonal projections in lanes, against the reference and in other company.
#include "core/surface/definition_text.h"
#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "support/threads.h"
#include "surface/definition_rows.h"
#include "surface/shapes.h"

#include <limits>
#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;
using shapes::sameBits;

class FeetTogetherTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void feetAreThoseOfTheReference_data();
    void feetAreThoseOfTheReference();
    void anyCompanyGivesTheSameBits();
    void placesWithoutNumbersSpoilNoOthers();
    void threadsDoNotChangeBits();
};

namespace {

/// Supports vary, and thin plates stand beside it: a part of the positions is of the common kind, a part is not.
Surface unevenTorus(Weight weight = Weight::Wendland, bool shrinkFree = true) {
    const double support = weight == Weight::Gaussian ? 0.4 : 0.24;
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.07, support), 0.01, test::seed());
    base::Random random(test::seed());
    for (surfel::Surfel& s : list.items)
        s.support *= static_cast<float>(random.uniform(0.8, 1.3));
    for (surfel::Surfel s : shapes::plates(8, 0.07, 0.24, 0.08).items) {
        s.position = s.position + Vec3f{3, 0, 0};
        list.items.push_back(s);
    }
    return shapes::surfaceOf(list, shapes::definitionOf(Frame::Normals, shrinkFree, weight));
}

std::vector<Vec3f> placesAbout(const Surface& surface, double away = 0.08) {
    base::Random random(test::seed() + 1);
    std::vector<Vec3f> out;
    for (const surfel::Surfel& s : surface.tree().surfels().items)
        out.push_back(s.position + base::cast<float>(random.unitVector() * random.uniform(0, away)));
    return out;
}

std::vector<Projection<float>> projected(const Surface& surface, std::span<const Vec3f> x) {
    std::vector<Projection<float>> out(x.size());
    project(surface, x, {}, out);
    return out;
}

bool same(const Projection<float>& a, const Projection<float>& b) {
    const auto matrix = [](const base::Mat3f& m) {
        return std::array{Vec3f{m.m[0][0], m.m[0][1], m.m[0][2]}, Vec3f{m.m[1][0], m.m[1][1], m.m[1][2]},
                          Vec3f{m.m[2][0], m.m[2][1], m.m[2][2]}};
    };
    const auto p = matrix(a.at.normalGradient), q = matrix(b.at.normalGradient);
    return a.status == b.status && a.iterations == b.iterations && sameBits(a.foot, b.foot) &&
           a.at.samples == b.at.samples && sameBits(a.at.value, b.at.value) && sameBits(a.at.unit, b.at.unit) &&
           sameBits(a.at.offCentre, b.at.offCentre) && sameBits(a.at.gradient, b.at.gradient) && sameBits(p[0], q[0]) &&
           sameBits(p[1], q[1]) && sameBits(p[2], q[2]);
}

/// What differs from the reference, or nothing.
QString difference(const Surface& surface, const Projection<float>& a, const Projection<double>& b) {
    if (a.status != b.status)
        return QString("status %1, not %2").arg(statusName(a.status), statusName(b.status));
    const double h = b.at.unit;
    const auto away = [](const Vec3f& p, const Vec3d& q) { return distance(base::cast<double>(p), q); };
    if (away(a.foot, b.foot) > 3e-5 * h)
        return QString("foot %1 h").arg(away(a.foot, b.foot) / h);
    const Evaluationd at = surface.evaluateReference(base::cast<double>(a.foot), Need::Gradient);
    if (a.at.samples != at.samples && std::abs(a.at.samples - at.samples) > 1) // one may be at the rim of its support
        return QString("%1 samples, not %2").arg(a.at.samples).arg(at.samples);
    if (std::abs(static_cast<double>(a.at.value) - at.value) > 3e-6 * h ||
        std::abs(static_cast<double>(a.at.unit) - at.unit) > 1e-5 * h ||
        std::abs(static_cast<double>(a.at.agreement) - at.agreement) > 1e-5)
        return "value, unit or agreement";
    if (away(a.at.centroid, at.centroid) > 5e-6 * h || away(a.at.normal, at.normal) > 1e-5 ||
        away(a.at.gradient, at.gradient) > 3e-5)
        return "centroid, normal or gradient";
    for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t c = 0; c < 3; ++c)
            if (std::abs(static_cast<double>(a.at.normalGradient.m[r][c]) - at.normalGradient.m[r][c]) > 1e-4 / h)
                return "derivative of the normal";
    return {};
}

} // namespace

void FeetTogetherTest::feetAreThoseOfTheReference_data() {
    QTest::addColumn<int>("weight");
    QTest::addColumn<bool>("shrinkFree");
    for (const auto& weight : weightNames())
        for (const bool shrinkFree : {true, false})
            QTest::addRow("%s mu=%d", weight.name, shrinkFree) << static_cast<int>(weight.value) << shrinkFree;
}

void FeetTogetherTest::feetAreThoseOfTheReference() {
    QFETCH(int, weight);
    QFETCH(bool, shrinkFree);
    const Surface surface = unevenTorus(static_cast<Weight>(weight), shrinkFree);
    const std::vector<Vec3f> x = placesAbout(surface);
    const auto feet = projected(surface, x);
    const std::size_t step = static_cast<std::size_t>(80 / test::effort(10));
    for (std::size_t i = 0; i < x.size(); i += step) {
        if (x[i].x > 2) // beside the plates two feet may be as near
            continue;
        const QString found = difference(surface, feet[i], projectReference(surface, base::cast<double>(x[i])));
        QVERIFY2(found.isEmpty(), qPrintable(QString("%1: %2, seed %3").arg(i).arg(found).arg(test::seed())));
    }
}

void FeetTogetherTest::anyCompanyGivesTheSameBits() {
    const Surface surface = unevenTorus();
    std::vector<Vec3f> x = placesAbout(surface);
    base::Random random(test::seed());
    for (std::size_t i = 0; i < x.size(); i += 50)
        x[i] = x[i] + base::cast<float>(random.unitVector() * 0.5); // outside of all supports
    const auto all = projected(surface, x);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t copies = random.below(3); copies > 0; --copies)
            order.push_back(i);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(i)]);
    std::vector<Vec3f> others;
    for (const std::size_t i : order)
        others.push_back(x[i]);
    const auto again = projected(surface, others);
    for (std::size_t k = 0; k < order.size(); ++k)
        QVERIFY2(same(all[order[k]], again[k]), qPrintable(QString("%1, seed %2").arg(order[k]).arg(test::seed())));
    for (std::size_t i = 0; i < x.size(); i += 7)
        QVERIFY2(same(all[i], project(surface, x[i])), qPrintable(QString("%1, seed %2").arg(i).arg(test::seed())));
}

void FeetTogetherTest::placesWithoutNumbersSpoilNoOthers() {
    const Surface surface = unevenTorus();
    std::vector<Vec3f> x = placesAbout(surface);
    x.resize(500);
    const auto all = projected(surface, x);
    std::vector<Vec3f> mixed;
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i % 5 == 0)
            mixed.push_back(i % 2 == 0 ? Vec3f{std::numeric_limits<float>::quiet_NaN(), 0, 0} : Vec3f{0, inf, 0});
        mixed.push_back(x[i]);
    }
    const auto beside = projected(surface, mixed);
    for (std::size_t i = 0, k = 0; k < mixed.size(); ++k)
        if (std::isfinite(mixed[k].x) && std::isfinite(mixed[k].y))
            QVERIFY(same(all[i++], beside[k]));
        else
            QVERIFY(!beside[k].ok());
}

void FeetTogetherTest::threadsDoNotChangeBits() {
    const Surface surface = unevenTorus();
    const std::vector<Vec3f> x = placesAbout(surface);
    const auto one = test::onThreads(1, [&] { return projected(surface, x); });
    const auto three = test::onThreads(3, [&] { return projected(surface, x); });
    for (std::size_t i = 0; i < x.size(); ++i)
        QVERIFY(same(one[i], three[i]));
}

static const test::Registered<FeetTogetherTest> registered;
#include "feet_together_test.moc"
