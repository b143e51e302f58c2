// Shadows and ambient occlusion against closed forms, first hits and cut models.
#include "core/raycast/blocking.h"

#include "core/raycast/directions.h"

#include "light_scenes.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using namespace raycast;
using base::Vec3d;
using base::Vec3f;
using scenes::pointAt;

class BlockingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aBallsShadowHasUmbraAndPenumbra();
    void theSkyAboveACupIsTheMissingPartOfTheBall();
    void aWallTakesItsFormFactor();
    void theGroundHoldsLightOff();
    void anyHitAgreesWithFirstHit();
    void aSheetCloseByIsNotLeapt_data();
    void aSheetCloseByIsNotLeapt();
    void whatIsCutAwayCastsNoShadow();
    void neighboursShareAllDirections();
    void placesBesideTheSurfaceAreMovedOntoIt();
};

static RayPatterns inTurn(std::size_t n) {
    RayPatterns out;
    for (std::size_t i = 0; i < n; ++i)
        out.pattern.push_back(static_cast<std::uint8_t>(i % raycast::patternCount));
    return out;
}

static surfel::SurfelList moved(surfel::SurfelList list, const Vec3f& by) {
    for (surfel::Surfel& s : list.items)
        s.position += by;
    return list;
}

static surfel::SurfelList joined(surfel::SurfelList a, const surfel::SurfelList& b) {
    a.items.insert(a.items.end(), b.items.begin(), b.items.end());
    return a;
}

void BlockingTest::aBallsShadowHasUmbraAndPenumbra() {
    // A round lamp of angle a straight above a ball of radius r at height H: rays tilted by a and tangent to the ball
    // meet the plane at r / cos a -+ H tan a.
    constexpr double r = 0.5, H = 1, spacing = 0.02;
    const auto ball = moved(shapes::sphere(8000, r, 3.5 * shapes::sphereSpacing(8000, r)), {0, 0, float(H)});
    Lighting lighting;
    lighting.directions = {{0, 0, 1}};
    lighting.shadowRays = 128;
    const LightScene scene(shapes::surfaceOf(joined(shapes::plane(50, spacing, 3.5 * spacing), ball)), lighting,
                           scenes::viewer());
    const double a = scene.environment.lamps().front().radius;
    const double umbra = r / std::cos(a) - H * std::tan(a), penumbra = r / std::cos(a) + H * std::tan(a);
    std::vector<LightPoint> points;
    for (int k = 0; k < 90; ++k)
        points.push_back(pointAt({0.01 * k * std::cos(2.4 * k), 0.01 * k * std::sin(2.4 * k), 0}, {0, 0, 1}, 0.07f));
    std::vector<float> seen(points.size());
    LightCounts counts;
    findShadows(scene, points, inTurn(points.size()), seen, counts);
    QCOMPARE(counts.shadowRays, points.size() * 128);
    for (int k = 0; k < 90; ++k) {
        const double at = 0.01 * k;
        const float part = seen[static_cast<std::size_t>(k)];
        const auto text = qPrintable(QString("%1 of the lamp at %2").arg(part).arg(at));
        if (at < umbra - 0.004)
            QVERIFY2(part < 1e-4f, text);
        else if (at > penumbra + 0.004)
            QVERIFY2(part > 1 - 1e-4f, text);
        else if (at > umbra + 0.01 && at < penumbra - 0.01) // half of it about half-way
            QVERIFY2(std::abs(part - (at - umbra) / (penumbra - umbra)) < 0.12, text);
    }
}

static float openAt(const LightScene& scene, const LightPoint& point) {
    float open = 0;
    LightCounts counts;
    findOcclusion(scene, {&point, 1}, {{0}}, {&open, 1}, counts);
    return open;
}

static Lighting farSky(int rays = 2048) {
    Lighting out;
    out.occlusion = true;
    out.occlusionRays = rays;
    out.occlusionReach = 10;
    return out;
}

void BlockingTest::theSkyAboveACupIsTheMissingPartOfTheBall() {
    // From the bottom of a spherical cup up to height z, the open part weighted with the cosine is rho^2 / (rho^2 +
    // h^2) = (1 - z) / 2: rho^2 = 1 - z^2, h = 1 + z.
    constexpr std::size_t n = 20000;
    const double spacing = shapes::sphereSpacing(n, 1);
    for (const double z : {-0.6, 0.0, 0.5, 2.0}) {
        surfel::SurfelList cup = shapes::sphere(n, 1, 3.5 * spacing);
        std::erase_if(cup.items, [&](const surfel::Surfel& s) { return s.position.z > z; });
        surface::SurfaceDefinition definition;
        definition.boundaryLimit = 0.3f;
        const LightScene scene(shapes::surfaceOf(cup, definition), farSky(), scenes::viewer());
        const float open = openAt(scene, pointAt({0, 0, -1}, {0, 0, 1}, static_cast<float>(3.5 * spacing)));
        const double expected = std::max(0.0, 0.5 * (1 - z));
        QVERIFY2(std::abs(open - expected) < 0.015, qPrintable(QString("%1: %2").arg(z).arg(open)));
    }
}

void BlockingTest::aWallTakesItsFormFactor() {
    // A wall of height H, endless to both sides, at distance a from a point of the floor: (1 - a / sqrt(a^2 + H^2))
    // / 2.
    constexpr double s = 0.05, H = 0.5;
    surfel::SurfelList wall;
    wall.layout = shapes::layout(true, true);
    for (double y = -5; y <= 5; y += s)
        for (double z = -0.5; z <= H; z += s)
            wall.items.push_back(shapes::surfelAt({0, y, z}, {1, 0, 0}, 3.5 * s));
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.25f;
    const LightScene scene(shapes::surfaceOf(wall, definition), farSky(), scenes::viewer());
    for (const double a : {0.25, 0.5, 1.0}) {
        const float open = openAt(scene, pointAt({a, 0, 0}, {0, 0, 1}, 3.5f * float(s)));
        const double expected = 1 - 0.5 * (1 - a / std::sqrt(a * a + H * H));
        QVERIFY2(std::abs(open - expected) < 0.015, qPrintable(QString("%1: %2, %3").arg(a).arg(open).arg(expected)));
    }
}

void BlockingTest::theGroundHoldsLightOff() {
    // A point of a small ball that looks down sees nothing but the ground; one that looks level sees half of it.
    Lighting lighting = farSky();
    lighting.ground = true;
    const LightScene scene(shapes::surfaceOf(shapes::sphere(3000, 0.2, 0.1)), lighting, scenes::viewer());
    QVERIFY(scene.ground.has_value());
    QVERIFY(openAt(scene, pointAt({0, -0.2, 0}, {0, -1, 0}, 0.1f)) < 1e-3f);
    QVERIFY(std::abs(openAt(scene, pointAt({0.2, 0, 0}, {1, 0, 0}, 0.1f)) - 0.5f) <
            0.03f); // what is far holds off none
    QVERIFY(openAt(scene, pointAt({0, 0.2, 0}, {0, 1, 0}, 0.1f)) > 1 - 1e-3f);
}

void BlockingTest::anyHitAgreesWithFirstHit() {
    // From points of the surface, as shadows ask; and from anywhere.
    base::Random random(test::seed());
    const LightScene scene(shapes::surfaceOf(shapes::torus(0.7, 0.3, 0.03, 0.1)), {}, scenes::viewer());
    std::vector<base::Rayf> rays;
    const surfel::SurfelList list = scene.surface.tree().surfels();
    for (int k = 0; k < test::effort(4000); ++k) {
        const surfel::Surfel& s = list.items[random.below(list.items.size())];
        const LightPoint point = pointAt(base::cast<double>(s.position), base::cast<double>(s.normal), s.support);
        Vec3f d = base::cast<float>(random.unitVector());
        d = dot(d, s.normal) < 0 ? -d : d;
        if (dot(d, s.normal) > 0.02f)
            rays.push_back({secondaryOrigin(point, point.n), d});
        const Vec3f from = base::cast<float>(random.unitVector() * 1.5);
        rays.push_back(
            {from, base::cast<float>(normalized(base::cast<double>(s.position - from) + random.unitVector() * 0.5))});
    }
    for (const float reach : {0.4f, std::numeric_limits<float>::infinity()}) {
        std::vector<std::uint8_t> any(rays.size());
        findBlocked(scene, rays, reach, any);
        std::vector<surface::RayHit<float>> first(rays.size());
        surface::IntersectOptions options;
        options.tMax = reach;
        intersect(scene.surface, rays, options, first);
        std::size_t apart = 0, hits = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits += first[i].hit;
            apart += (any[i] != 0) != first[i].hit ? 1 : 0;
            QCOMPARE(any[i] != 0, intersectAny(scene.surface.surface(), rays[i], options));
        }
        QVERIFY2(
            hits > rays.size() / 400 && apart * 1000 <= rays.size(),
            qPrintable(
                QString("%1 of %2 differ, %4 hits, seed %3").arg(apart).arg(rays.size()).arg(test::seed()).arg(hits)));
    }
}

void BlockingTest::aSheetCloseByIsNotLeapt_data() {
    QTest::addColumn<double>("gap"); // in units of h
    QTest::addColumn<double>("normal");
    for (const double gap : {0.25, 0.35, 0.5, 0.65, 0.8, 1.0, 1.3})
        for (const double normal : {-1.0, 1.0})
            QTest::addRow("%g h %s", gap, normal < 0 ? "facing" : "alike") << gap << normal;
}

/// Any-hit looks once where marches look often: from one sheet to the next nothing may get lost between two looks.
void BlockingTest::aSheetCloseByIsNotLeapt() {
    QFETCH(double, gap);
    QFETCH(double, normal);
    constexpr double spacing = 0.05, h = 3.5 * spacing;
    const auto model =
        shapes::surfaceOf(joined(shapes::plane(40, spacing, h), shapes::plane(40, spacing, h, gap * h, normal)));
    base::Random random(test::seed());
    std::vector<base::Rayf> rays;
    for (int k = 0; k < test::effort(800); ++k) {
        const LightPoint point = pointAt({random.uniform(-1, 1), random.uniform(-1, 1), 0}, {0, 0, 1}, float(h));
        Vec3d d = random.unitVector();
        d.z = std::abs(d.z) + 0.15;
        rays.push_back({secondaryOrigin(point, point.n), base::cast<float>(normalized(d))});
    }
    std::vector<std::uint8_t> any(rays.size());
    surface::intersectAny(model, rays, {}, any);
    std::size_t lost = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
        lost += intersect(model, rays[i]).hit && !any[i] ? 1 : 0;
    QVERIFY2(lost == 0, qPrintable(QString("%1 lost, seed %2").arg(lost).arg(test::seed())));
}

void BlockingTest::whatIsCutAwayCastsNoShadow() {
    const auto model = shapes::surfaceOf(shapes::plane(20, 0.05, 0.17, 1));
    const base::Plane below{{0, 0, -1}, -0.5}; // keeps z <= 0.5
    const std::vector<base::Rayf> rays{{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 2}, {0, 0, -1}}};
    std::vector<std::uint8_t> whole(2), cut(2);
    findBlocked(LightScene(model, {}, scenes::viewer()), rays, 100, whole);
    findBlocked(LightScene(model, {}, scenes::viewer(), {&below, 1}), std::span(rays).first(1), 100, cut);
    QVERIFY(whole[0] == 1 && whole[1] == 1 && cut[0] == 0);
}

void BlockingTest::neighboursShareAllDirections() {
    // Any 4 x 4 pixels of an image, and any eight points in a row that are no neighbours, look into the same set.
    const auto directions = [](const RayPatterns& patterns, std::span<const std::size_t> points) {
        std::set<std::pair<float, float>> out;
        for (const std::size_t i : points)
            for (int j = 0; j < 3 * patterns.factor; ++j) {
                const UnitSquarePoint point = unitSquarePoint(patterns.pattern[i], j, 3 * patterns.factor);
                out.insert({point.u, point.v});
            }
        return out;
    };
    const RayPatterns image = rayPatternsOf({{}, {}, 21}, 0, 21 * 9), apart = rayPatternsOf({{}, {}, 0}, 64, 32);
    std::set<std::pair<float, float>> all;
    for (const std::size_t corner : {0u, 5u, 21u * 3 + 10, 21u * 5 + 17}) {
        std::vector<std::size_t> square, row;
        for (std::size_t k = 0; k < 16; ++k)
            square.push_back(corner + k / 4 * 21 + k % 4);
        for (std::size_t k = 0; k < 8; ++k)
            row.push_back(corner % 24 + k);
        const auto found = directions(image, square);
        QCOMPARE(found.size(), std::size_t(16 * 3));
        QVERIFY(found == directions(apart, row) && (all.empty() || found == all));
        all = found;
    }
}

void BlockingTest::placesBesideTheSurfaceAreMovedOntoIt() {
    // Adaptive pictures interpolate positions, to a fifth of a spacing.
    constexpr double spacing = 0.05;
    const LightScene scene(shapes::surfaceOf(shapes::sphere(5000, 1, 3.5 * spacing)), {}, scenes::viewer());
    base::Random random(test::seed());
    std::vector<Sample> samples(200);
    for (Sample& sample : samples) {
        const Vec3d d = random.unitVector();
        sample.hit.hit = true;
        sample.hit.position = base::cast<float>(d * (1 + 0.2 * spacing * random.uniform(-1, 1)));
        sample.hit.normal = sample.hit.outward = base::cast<float>(d);
    }
    std::vector<LightPoint> points(samples.size());
    findLightPoints(scene, {samples, [](std::size_t) { return base::Rayd{}; }}, 0, points);
    for (const LightPoint& point : points) {
        QVERIFY(std::abs(scene.surface.surface().evaluate(point.x).value) < 2e-4f * point.unit);
        const surface::Evaluationf at = scene.surface.surface().evaluate(secondaryOrigin(point, point.n));
        QVERIFY2(at.value > 0 && at.value < 1e-3f * point.unit, "a start is not beside the surface");
    }
}

static const test::Registered<BlockingTest> registered;
#include "blocking_test.moc"
