// Finer discs lie on a cubic through seven feet where that is the surface, and cover the disc that they stand for.
#include "core/base/random.h"
#include "core/render/splats/smooth_patch.h"
#include "core/render/splats/spread_discs.h"
#include "support/registry.h"

#include <QTest>

#include <numbers>

using namespace render;
using base::Vec3d;
using base::Vec3f;

class SmoothPatchTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cubicsAreTheirOwnPatches();
    void patchesOfBallsLieOnThem();
    void nothingGoesThroughSteps();
    void latticesCoverTheirDisc_data();
    void latticesCoverTheirDisc();
    void discsAreAsManyAsTheyStandOut();
};

namespace {

/// Heights of a cubic over a plane of space, whatever its place and turn.
struct Cubic {
    Vec3d origin, u, v, n;
    std::array<double, 10> k{};

    explicit Cubic(base::Random& random) : origin(random.unitVector() * 5.0), n(random.unitVector()) {
        u = base::perpendicular(n), v = cross(n, u);
        for (double& each : k)
            each = random.uniform(-0.2, 0.2);
        k[0] = k[1] = k[2] = 0; // the middle foot is at the origin, and its normal is n
    }
    Foot at(double a, double b) const {
        const double z = k[3] * a * a + k[4] * a * b + k[5] * b * b + k[6] * a * a * a + k[7] * a * a * b +
                         k[8] * a * b * b + k[9] * b * b * b,
                     za = 2 * k[3] * a + k[4] * b + 3 * k[6] * a * a + 2 * k[7] * a * b + k[8] * b * b,
                     zb = k[4] * a + 2 * k[5] * b + k[7] * a * a + 2 * k[8] * a * b + 3 * k[9] * b * b;
        return {base::cast<float>(origin + u * a + v * b + n * z), base::cast<float>(normalized(n - u * za - v * zb))};
    }
};

/// About where discs have them, shaken.
template <class At>
std::vector<Foot> sevenFeet(base::Random& random, const At& at) {
    std::vector<Foot> out{at(0.0, 0.0)};
    for (int i = 0; i < 6; ++i) {
        const double angle = i * std::numbers::pi / 3 + random.uniform(-0.1, 0.1), r = random.uniform(0.65, 0.8);
        out.push_back(at(r * std::cos(angle), r * std::sin(angle)));
    }
    return out;
}

} // namespace

void SmoothPatchTest::cubicsAreTheirOwnPatches() {
    base::Random random(test::seed());
    for (int model = 0; model < 50; ++model) {
        const Cubic cubic(random);
        const auto patch =
            SmoothPatch::through(sevenFeet(random, [&](double a, double b) { return cubic.at(a, b); }), 1, 1e-3f);
        QVERIFY2(patch, qPrintable(QString("%1, seed %2").arg(model).arg(test::seed())));
        for (int i = 0; i < 20; ++i) {
            const Foot told = cubic.at(random.uniform(-0.9, 0.9), random.uniform(-0.9, 0.9));
            const Foot found = patch->at(told.position + base::cast<float>(cubic.n * random.uniform(-1, 1)));
            const QString where = QString("%1, %2 off, seed %3")
                                      .arg(model)
                                      .arg(double(distance(found.position, told.position)))
                                      .arg(test::seed());
            QVERIFY2(distance(found.position, told.position) < 2e-5f, qPrintable(where));
            QVERIFY2(dot(found.normal, told.normal) > 1 - 1e-6f, qPrintable(where));
        }
    }
}

/// What is left out is of fourth order: a sixteenth for half the radius.
void SmoothPatchTest::patchesOfBallsLieOnThem() {
    base::Random random(test::seed());
    const auto ball = [](double a, double b) {
        const Vec3d p{a, b, std::sqrt(1 - a * a - b * b)};
        return Foot{base::cast<float>(p), base::cast<float>(p)};
    };
    double before = 0;
    for (const float radius : {0.6f, 0.3f}) {
        const auto feet =
            sevenFeet(random, [&](double a, double b) { return ball(double(radius) * a, double(radius) * b); });
        const auto patch = SmoothPatch::through(feet, radius, radius);
        QVERIFY(patch);
        double most = 0;
        for (int i = 0; i < 400; ++i) {
            const double angle = random.uniform(0, 6.28), r = double(radius) * random.uniform(0, 0.95);
            const Foot foot = patch->at(base::cast<float>(Vec3d{r * std::cos(angle), r * std::sin(angle), 1}));
            most = std::max(most, std::abs(double(length(foot.position)) - 1));
        }
        const QString found = QString("%1 at radius %2, seed %3").arg(most).arg(double(radius)).arg(test::seed());
        QVERIFY2(most < 0.1 * std::pow(double(radius), 4), qPrintable(found));
        QVERIFY2(before == 0 || most < before / 8, qPrintable(found));
        before = most;
    }
}

/// Two sheets, one of whose feet is on the other, a crease, and a foot that turns away.
void SmoothPatchTest::nothingGoesThroughSteps() {
    base::Random random(test::seed());
    const auto none = [&](const auto& at) {
        const auto feet = sevenFeet(random, at);
        const bool through = SmoothPatch::through(feet, 1, 0.02f).has_value();
        QVERIFY2(!through, qPrintable(QString("seed %1").arg(test::seed())));
    };
    none([](double a, double) { return Foot{{float(a), 0, a > 0.5 ? 0.2f : 0}, {0, 0, 1}}; });
    none([](double a, double b) {
        return Foot{{float(a), float(b), float(-0.7 * std::max(0.0, a))},
                    a > 0 ? normalized(Vec3f{0.7f, 0, 1}) : Vec3f{0, 0, 1}};
    });
    none([](double a, double b) {
        return Foot{{float(a), float(b), 0}, a > 0.5 ? normalized(Vec3f{1, 0, 0.2f}) : Vec3f{0, 0, 1}};
    });
}

void SmoothPatchTest::latticesCoverTheirDisc_data() {
    QTest::addColumn<int>("rings");
    for (int rings = 0; rings <= mostRings; ++rings)
        QTest::newRow(qPrintable(QString("%1 rings").arg(rings))) << rings;
}

/// But for its last tenth, and a twentieth of a finer radius; at the ends of surfaces half as far again.
void SmoothPatchTest::latticesCoverTheirDisc() {
    QFETCH(int, rings);
    base::Random random(test::seed());
    for (const bool ends : {false, true}) {
        const Vec3f n = base::cast<float>(random.unitVector());
        const std::vector<Vec3f> places = spreadPlaces(n, rings, ends);
        QVERIFY(places.front() == Vec3f());
        QCOMPARE(places.size() == 7, rings == 1);
        const float radius = spreadRadius(rings), reach = ends && rings > 1 ? 1.5f : 0.9f;
        const Vec3f u = base::perpendicular(n), v = cross(n, u);
        for (int i = 0; i < 2000; ++i) {
            const auto angle = static_cast<float>(random.uniform(0, 6.2832)),
                       r = reach * static_cast<float>(std::sqrt(random.uniform()));
            const Vec3f x = u * (r * std::cos(angle)) + v * (r * std::sin(angle));
            float nearest = 9;
            for (const Vec3f& place : places) {
                QVERIFY(std::abs(dot(place, n)) < 1e-5f);
                nearest = std::min(nearest, distance(place, x));
            }
            QVERIFY2(nearest <= 1.05f * radius, qPrintable(QString("%1 of %2 at %3, seed %4")
                                                               .arg(double(nearest))
                                                               .arg(double(radius))
                                                               .arg(double(r))
                                                               .arg(test::seed())));
        }
    }
}

/// More where more stands out or the surface ends, none where nobody sees it, and never too small to be seen.
void SmoothPatchTest::discsAreAsManyAsTheyStandOut() {
    QCOMPARE(spreadRings({3, 9, true}), 0);
    base::Random random(test::seed());
    for (int i = 0; i < 1000; ++i) {
        const SeenDisc disc{float(random.uniform(4, 80)), float(random.uniform(0, 12)), random.uniform() < 0.5};
        const int rings = spreadRings(disc);
        QVERIFY(rings >= 1 && rings <= mostRings);
        QVERIFY(rings == 1 || spreadRadius(rings) * disc.radius > 2);
        QVERIFY(spreadRings({disc.radius, 2 * disc.standOut, true}) >= rings);
        const float left = disc.standOut * spreadRadius(rings) * spreadRadius(rings);
        QVERIFY(left <= 0.71f || rings == mostRings || spreadRadius(rings + 1) * disc.radius < 2.51f);
    }
}

static const test::Registered<SmoothPatchTest> registered;
#include "smooth_patch_test.moc"
