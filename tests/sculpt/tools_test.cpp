// What draw, clay, smooth and grab do to a point, against their formulas and against analytic shapes.
#include "sculpt/dabs.h"
#include "support/registry.h"

#include <QTest>

using namespace sculpt;

class ToolsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void drawRaisesThePlaneByTheFalloffExactly();
    void drawnNormalsAreThoseOfTheGraphOfTheFalloff();
    void clayNeverPassesItsPlaneAndFillsHollowsFirst();
    void invertedClayIsClayUpsideDown();
    void smoothKeepsASphereAndTakesItsNoise();
    void smoothTakesShortReliefAndKeepsLongRelief();
    void smoothMovesNothingSideways();
    void grabCarriesItsPlateauRigidly();
    void grabIsItsOwnInverseBackwards();
};

using test::applied;
using test::dabOf;

void ToolsTest::drawRaisesThePlaneByTheFalloffExactly() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, 0.02));
    for (const FalloffRow& falloff : falloffTable())
        for (const float strength : {1.0f, 0.3f, -0.6f}) {
            Dab dab = dabOf(tool("draw"), {0.013f, -0.02f, 0}, 0.4f, strength);
            dab.falloff = falloff.value;
            const surface::Surface after = applied(tool("draw"), plane, dab);
            for (const surfel::Surfel& s : after.tree().surfels().items) {
                const double x = double(s.position.x) - double(dab.centre.x),
                             y = double(s.position.y) - double(dab.centre.y);
                const double expected = double(strength) * 0.05 * double(dab.radius) *
                                        double(weight(falloff.value, float(std::hypot(x, y) / double(dab.radius))));
                QVERIFY2(std::abs(double(s.position.z) - expected) < 2e-6 * double(dab.radius), falloff.id);
            }
        }
}

void ToolsTest::drawnNormalsAreThoseOfTheGraphOfTheFalloff() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(80, 0.02));
    const Dab dab = dabOf(tool("draw"), {0, 0, 0}, 0.4f, 1);
    const surface::Surface after = applied(tool("draw"), plane, dab);
    for (const surfel::Surfel& s : after.tree().surfels().items) {
        const double x = double(s.position.x), y = double(s.position.y), r = std::hypot(x, y) / 0.4;
        const double slope = r < 1 && r > 1e-9 ? 0.05 * 6 * r * (r - 1) / (r * 0.4) : 0; // of height over r, by x and y
        const base::Vec3d n = normalized(base::Vec3d{-slope * x, -slope * y, 1});
        QVERIFY(length(n - base::cast<double>(s.normal)) < 1e-5);
    }
}

void ToolsTest::clayNeverPassesItsPlaneAndFillsHollowsFirst() {
    surfel::SurfelList points = test::planePoints(80, 0.02);
    for (surfel::Surfel& s : points.items)
        s.position.z = s.position.x < 0 ? -0.05f : 0.02f;
    surface::Surface s = test::surfaceOf(points);
    const Dab dab = dabOf(tool("clay"), {0, 0, 0}, 0.4f, 1);
    const float plane = 0.25f * dab.radius;
    const auto zAt = [&](float x) {
        std::vector<tree::Neighbour> found;
        s.tree().nearest({x, 0, x < 0 ? -0.05f : 0.02f}, 1, found);
        return found[0].block->position(found[0].slot).z;
    };
    const float gapBefore = zAt(0.1f) - zAt(-0.1f);
    s = applied(tool("clay"), s, dab);
    const float gapAfter = s.tree().bounds().size().z;
    QVERIFY(gapBefore > 0.06f);
    QVERIFY(zAt(0.1f) - zAt(-0.1f) < 0.95f * gapBefore);
    QVERIFY(gapAfter > 0);
    for (int k = 0; k < 200; ++k)
        s = applied(tool("clay"), s, dab);
    const float top = s.tree().bounds().hi.z;
    QVERIFY(top <= plane && top > 0.9f * plane);
}

void ToolsTest::invertedClayIsClayUpsideDown() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.02));
    const auto up = applied(tool("clay"), plane, dabOf(tool("clay"), {}, 0.3f, 0.7f)).tree().surfels().items;
    const auto down = applied(tool("clay"), plane, dabOf(tool("clay"), {}, 0.3f, -0.7f)).tree().surfels().items;
    float highest = 0;
    for (std::size_t i = 0; i < up.size(); ++i) {
        QCOMPARE(up[i].position.z, -down[i].position.z);
        highest = std::max(highest, up[i].position.z);
    }
    QVERIFY(highest > 0);
}

void ToolsTest::smoothKeepsASphereAndTakesItsNoise() {
    constexpr std::size_t count = 10000;
    const double s = test::sphereSpacing(count);
    surfel::SurfelList points = test::spherePoints(count);
    base::Random random(test::seed());
    for (surfel::Surfel& each : points.items)
        each.position = each.position * float(1 + 0.2 * s * random.normal());
    surface::Surface even = test::surfaceOf(test::spherePoints(count)), noisy = test::surfaceOf(points);
    Dab dab = dabOf(tool("smooth"), {0, 0, 1}, 5, 1);
    dab.falloff = Falloff::Constant;
    const auto deviation = [](const surface::Surface& surface) {
        double sum = 0, sq = 0;
        for (const surfel::Surfel& each : surface.tree().surfels().items) {
            const double d = length(base::cast<double>(each.position)) - 1;
            sum += d, sq += d * d;
        }
        const double n = double(surface.tree().size());
        return std::pair{sum / n, std::sqrt(sq / n)};
    };
    const double before = deviation(noisy).second;
    for (int k = 0; k < 30; ++k) {
        even = applied(tool("smooth"), even, dab);
        noisy = applied(tool("smooth"), noisy, dab);
    }
    QVERIFY2(std::abs(deviation(even).first) < 2e-5 && deviation(even).second < 5e-5,
             qPrintable(QString("mean %1, rms %2").arg(deviation(even).first).arg(deviation(even).second)));
    QVERIFY2(deviation(noisy).second < 0.2 * before && std::abs(deviation(noisy).first) < 0.05 * s,
             qPrintable(QString("rms %1 of %2, mean %3 s")
                            .arg(deviation(noisy).second)
                            .arg(before)
                            .arg(deviation(noisy).first / s)));
}

/// Part of the amplitude of a relief of `wavelength` spacings that `rounds` full dabs leave.
static double reliefLeft(double wavelength, int rounds) {
    constexpr double s = 0.02;
    surfel::SurfelList points = test::planePoints(60, s);
    const double k = 2 * std::numbers::pi / (wavelength * s), a = 0.05 * wavelength * s;
    for (surfel::Surfel& each : points.items) {
        const double x = double(each.position.x);
        each.position.z = float(a * std::sin(k * x));
        each.normal = base::cast<float>(normalized(base::Vec3d{-a * k * std::cos(k * x), 0, 1}));
    }
    surface::Surface surface = test::surfaceOf(points);
    Dab dab = dabOf(tool("smooth"), {}, 5, 1);
    dab.falloff = Falloff::Constant;
    for (int round = 0; round < rounds; ++round)
        surface = applied(tool("smooth"), surface, dab);
    double projected = 0, norm = 0;
    for (const surfel::Surfel& each : surface.tree().surfels().items) {
        if (std::abs(each.position.x) > 0.3f || std::abs(each.position.y) > 0.3f)
            continue; // away from the borders
        const double wave = std::sin(k * double(each.position.x));
        projected += double(each.position.z) * wave, norm += wave * wave;
    }
    return projected / norm / a;
}

void ToolsTest::smoothTakesShortReliefAndKeepsLongRelief() {
    const double four = reliefLeft(4, 10), twelve = reliefLeft(12, 10), thirty = reliefLeft(30, 10);
    const QString told = QString("%1 %2 %3").arg(four).arg(twelve).arg(thirty);
    QVERIFY2(four < 0.1, qPrintable(told));
    QVERIFY2(twelve > 0.5, qPrintable(told));
    QVERIFY2(thirty > 0.97 && thirty < 1.01, qPrintable(told));
}

void ToolsTest::smoothMovesNothingSideways() {
    // An open plane with an uneven, jagged border: in its plane nothing may move.
    surfel::SurfelList points = test::planePoints(50, 0.02);
    base::Random random(test::seed());
    std::erase_if(points.items, [&](const surfel::Surfel&) { return random.uniform() < 0.1; });
    surface::Surface s = test::surfaceOf(points);
    const auto before = s.tree().surfels().items;
    s = applied(tool("smooth"), s, dabOf(tool("smooth"), {}, 0.4f, 1));
    const auto after = s.tree().surfels().items;
    for (std::size_t i = 0; i < before.size(); ++i)
        QVERIFY(distance(before[i].position, after[i].position) < 1e-6f);
}

void ToolsTest::grabCarriesItsPlateauRigidly() {
    const surface::Surface plane = test::surfaceOf(test::planePoints(60, 0.02));
    Dab dab = dabOf(tool("grab"), {}, 0.4f, 1);
    dab.move = {0.01f, 0.02f, 0.03f};
    const auto before = plane.tree().surfels().items, after = applied(tool("grab"), plane, dab).tree().surfels().items;
    int held = 0;
    for (const surfel::Surfel& s : before) {
        if (length(s.position) > 0.25f * dab.radius - length(dab.move))
            continue;
        const base::Vec3f there = s.position + dab.move;
        held += std::any_of(after.begin(), after.end(), [&](const surfel::Surfel& t) {
            return distance(t.position, there) < 1e-7f && t.normal == s.normal;
        });
        QVERIFY(held > 0);
    }
    QVERIFY(held >= 9);
}

void ToolsTest::grabIsItsOwnInverseBackwards() {
    const surface::Surface start = test::surfaceOf(test::spherePoints(8000));
    surface::Surface s = start;
    Dab dab = dabOf(tool("grab"), {0, 0, 1}, 0.4f, 1);
    base::Random random(test::seed());
    std::vector<base::Vec3f> path;
    for (int k = 0; k < 25; ++k)
        path.push_back(base::cast<float>(random.unitVector() * 0.03 + base::Vec3d{0, 0, 0.02}));
    for (const base::Vec3f& step : path) {
        dab.move = step;
        s = applied(tool("grab"), s, dab);
        dab.centre += step;
    }
    QVERIFY(s.tree().bounds().hi.z > 1.2f);
    for (std::size_t k = path.size(); k-- > 0;) {
        dab.move = -path[k];
        s = applied(tool("grab"), s, dab);
        dab.centre -= path[k];
    }
    std::vector<tree::Neighbour> found;
    for (const surfel::Surfel& each : s.tree().surfels().items) {
        start.tree().nearest(each.position, 1, found);
        QVERIFY(std::sqrt(found[0].distanceSq) < 2e-5f);
        QVERIFY(distance(found[0].block->normal(found[0].slot), each.normal) < 1e-3f);
    }
}

static const test::Registered<ToolsTest> registered;
#include "tools_test.moc"
