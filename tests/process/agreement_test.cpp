// Normals of a file that do not agree on a side are made to; those that do stay, walls and noise included.
#include "core/base/random.h"
#include "core/process/estimation/prepare.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;

class AgreementTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void normalsOfHalfOfSpaceAgreeAgain_data();
    void normalsOfHalfOfSpaceAgreeAgain();
    void whatAgreesStays_data();
    void whatAgreesStays();
    void nobodyTurnsUnasked();
};

namespace {

surfel::SurfelList oriented() {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    return out;
}

void add(surfel::SurfelList& to, const Vec3d& x, const Vec3d& n) {
    surfel::Surfel s;
    s.position = base::cast<float>(x), s.normal = base::cast<float>(n);
    to.append(s, {});
}

/// By chance over a torus, `ratio` times as many on one side as on the other.
surfel::SurfelList torus(std::size_t count, double ratio, base::Random& random) {
    surfel::SurfelList out = oriented();
    while (out.size() < count) {
        const double a = random.uniform(0, 2 * std::numbers::pi), b = random.uniform(0, 2 * std::numbers::pi);
        if (random.uniform() > (0.7 + 0.3 * std::cos(b)) * std::pow(ratio, -0.5 - 0.5 * std::cos(a)))
            continue;
        const Vec3d out1{std::cos(a), std::sin(a), 0}, n = out1 * std::cos(b) + Vec3d{0, 0, std::sin(b)};
        add(out, out1 * 0.7 + n * 0.3, n);
    }
    return out;
}

/// A box with round edges: the points that lie `radius` off a smaller one.
surfel::SurfelList roundBox(std::size_t count, double radius, base::Random& random) {
    surfel::SurfelList out = oriented();
    while (out.size() < count) {
        const Vec3d core{random.uniform(-1, 1), random.uniform(-0.6, 0.6), random.uniform(-0.4, 0.4)};
        Vec3d d{0, 0, 0};
        const int sides = 1 + static_cast<int>(random.below(3));
        for (int k = 0; k < sides; ++k) {
            const auto axis = random.below(3);
            (axis == 0 ? d.x : axis == 1 ? d.y : d.z) = random.uniform(-1, 1);
        }
        const auto snapped = [](double at, double way, double half) {
            return way == 0 ? at : std::copysign(half, way);
        };
        if (length(d) < 1e-3)
            continue;
        const Vec3d n = normalized(d);
        add(out, Vec3d{snapped(core.x, d.x, 1), snapped(core.y, d.y, 0.6), snapped(core.z, d.z, 0.4)} + n * radius, n);
    }
    return out;
}

void intoHalfOfSpace(surfel::SurfelList& list, const Vec3d& towards) {
    const base::Vec3f w = base::cast<float>(towards);
    for (surfel::Surfel& s : list.items)
        if (dot(s.normal, w) < 0)
            s.normal = -s.normal;
}

/// How many of the surface's normals are those of `outwards`, by their places.
double agreeing(const surface::Surface& found, const surfel::SurfelList& outwards) {
    std::map<std::array<float, 3>, base::Vec3f> known;
    for (const surfel::Surfel& s : outwards.items)
        known[{s.position.x, s.position.y, s.position.z}] = s.normal;
    std::size_t same = 0;
    for (const surfel::Surfel& s : found.tree().surfels().items)
        same += dot(known.at({s.position.x, s.position.y, s.position.z}), s.normal) > 0 ? 1 : 0;
    return static_cast<double>(same) / static_cast<double>(outwards.size());
}

surface::Surface prepared(const surfel::SurfelList& list, std::size_t* disagreed) {
    process::PrepareOptions options;
    bool turned = false;
    options.disagreed = disagreed;
    options.turned = &turned;
    return process::prepare(list, options);
}

} // namespace

void AgreementTest::normalsOfHalfOfSpaceAgreeAgain_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("torus") << 0;
    QTest::newRow("uneven torus") << 1;
    QTest::newRow("box with round edges") << 2;
}

void AgreementTest::normalsOfHalfOfSpaceAgreeAgain() {
    QFETCH(int, shape);
    for (int round = 0; round < test::effort(5); ++round) {
        const auto seed = test::seed() + static_cast<unsigned long long>(round);
        base::Random random(seed);
        const surfel::SurfelList outwards =
            shape == 2 ? roundBox(6000, 0.15, random) : torus(4000, shape == 1 ? 9 : 1, random);
        surfel::SurfelList list = outwards;
        intoHalfOfSpace(list, random.unitVector());
        std::size_t disagreed = 0;
        const double same = agreeing(prepared(list, &disagreed), outwards);
        QVERIFY2(disagreed > list.size() / 5 && same > 0.995,
                 qPrintable(QString("%1 turned, %2 agree, seed %3").arg(disagreed).arg(same).arg(seed)));
    }
}

void AgreementTest::whatAgreesStays_data() {
    QTest::addColumn<int>("shape");
    QTest::newRow("torus") << 0;
    QTest::newRow("box") << 1;
    QTest::newRow("wall of .6 spacings") << 2;
    QTest::newRow("noise") << 3;
}

/// To the bit: nobody was asked to better what is right.
void AgreementTest::whatAgreesStays() {
    QFETCH(int, shape);
    base::Random random(test::seed());
    surfel::SurfelList list = shape == 1   ? roundBox(6000, 0.01, random)
                              : shape == 2 ? oriented()
                                           : torus(4000, 9, random);
    if (shape == 2)
        for (int k = 0; k < 6000; ++k) { // a spacing of .018
            const bool up = random.uniform() < 0.5;
            add(list, {random.uniform(), random.uniform(), up ? 0.011 : 0}, {0, 0, up ? 1.0 : -1.0});
        }
    if (shape == 3) // a tenth of a spacing and 15 degrees
        for (surfel::Surfel& s : list.items) {
            s.position += base::cast<float>(random.unitVector() * 0.003);
            s.normal = normalized(s.normal + base::cast<float>(random.unitVector() * 0.25));
        }
    std::size_t disagreed = 0;
    const surface::Surface asked = prepared(list, &disagreed);
    QVERIFY2(disagreed == 0, qPrintable(QString("%1 turned, seed %2").arg(disagreed).arg(test::seed())));
    QCOMPARE(asked.tree().contentHash(), prepared(list, nullptr).tree().contentHash());
}

void AgreementTest::nobodyTurnsUnasked() {
    base::Random random(test::seed());
    surfel::SurfelList list = torus(2000, 1, random);
    intoHalfOfSpace(list, {0, 0, 1});
    QVERIFY(agreeing(process::prepare(list, {}), list) == 1);
}

static const test::Registered<AgreementTest> registered;
#include "agreement_test.moc"
