// Glass and metal against the laws of optics, and against a ball followed by hand.
#include "core/raycast/light_paths.h"

#include "core/raycast/optics.h"
#include "light_scenes.h"
#include "support/registry.h"

#include <QTest>

using namespace raycast;
using base::Vec3d;
using base::Vec3f;

class LightPathsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void snellFresnelAndBeer();
    void aGlassBallTurnsRaysByTwiceTheDifferenceOfAngles();
    void aGlassBallIsAsFollowedByHand();
    void lightOffTheMiddleIsAbsorbedLess();
    void aMirrorBallShowsTheReflectedRoom();
    void whatHasNoInsideIsAPane();
    void whereNothingLiesBehindItIsAPane();
};

void LightPathsTest::snellFresnelAndBeer() {
    base::Random random(test::seed());
    for (int k = 0; k < test::effort(2000); ++k) {
        const Vec3f n = base::cast<float>(random.unitVector());
        Vec3f d = base::cast<float>(random.unitVector());
        d = dot(d, n) > 0 ? -d : d;
        const float eta = static_cast<float>(random.uniform(0.5, 2)), c = -dot(d, n), sine = length(cross(d, n));
        const auto out = refracted(d, n, eta);
        QCOMPARE(out.has_value(), eta * sine <= 1); // total reflection beyond the critical angle
        const Vec3f mirror = mirrored(d, n);
        QVERIFY(std::abs(dot(mirror, n) - c) < 1e-5f && length(cross(mirror, n) - cross(d, n)) < 1e-5f);
        if (!out) {
            QCOMPARE(reflectance(c, eta), 1.0f);
            continue;
        }
        QVERIFY(std::abs(length(cross(*out, n)) - eta * sine) < 1e-5f && dot(*out, n) <= 0);
        QVERIFY(std::abs(dot(cross(*out, d), n)) < 1e-5f); // in one plane
        // the way back reflects the same part, and turns the ray back
        QVERIFY(std::abs(reflectance(c, eta) - reflectance(-dot(*out, n), 1 / eta)) < 5e-3f);
        const auto back = refracted(-*out, -n, 1 / eta);
        QVERIFY(back && length(*back + d) < 2e-3f);
    }
    QVERIFY(std::abs(reflectance(1, 1 / 1.5f) - 0.04f) < 1e-6f);
    const float brewster = std::cos(std::atan(1.5f)); // light that swings along is not reflected: half of the other
    const float across =
        (1 / 1.5f * brewster - std::sin(std::atan(1.5f))) / (1 / 1.5f * brewster + std::sin(std::atan(1.5f)));
    QVERIFY(std::abs(reflectance(brewster, 1 / 1.5f) - 0.5f * across * across) < 1e-5f);
    const Vec3f once = transmitted({1, 2, 3}, 0.7f), twice = transmitted({1, 2, 3}, 1.4f);
    QVERIFY(std::abs(once.y - std::exp(-1.4f)) < 1e-6f && length(times(once, once) - twice) < 1e-6f);
}

constexpr std::size_t count = 20000;
static const surface::Surface& ball() {
    static const surface::Surface out =
        shapes::surfaceOf(shapes::sphere(count, 1, 3.5 * shapes::sphereSpacing(count, 1)));
    return out;
}

void LightPathsTest::aGlassBallTurnsRaysByTwiceTheDifferenceOfAngles() {
    for (const double b : {0.0, 0.2, 0.5, 0.8, 0.95}) {
        const Vec3f d{0, 0, -1};
        const auto in = intersect(ball(), {{0, static_cast<float>(b), 3}, d});
        QVERIFY(in.hit);
        const auto inside = refracted(d, in.normal, 1 / 1.5f);
        LightPoint at;
        at.x = in.position, at.unit = in.unit;
        const auto out = intersect(ball(), {secondaryOrigin(at, -in.normal), *inside});
        QVERIFY(out.hit && dot(out.outward, *inside) > 0);
        const auto gone = refracted(*inside, out.normal, 1.5f);
        QVERIFY(gone);
        const double i = std::asin(b), r = std::asin(b / 1.5), turned = std::acos(std::min(1.0f, dot(*gone, d)));
        QVERIFY2(std::abs(turned - 2 * (i - r)) < 2e-3, qPrintable(QString("%1: %2").arg(b).arg(turned)));
        QVERIFY(std::abs(out.t - 2 * std::cos(r)) < 2e-3); // the chord
    }
}

/// Light along a ray from outside or inside the unit ball, exactly.
static Vec3f byHand(const LightScene& scene, const Vec3d& x, const Vec3f& d, bool inside, const Vec3f& weight,
                    int bounces) {
    const MaterialRow& glass = materialRow(Material::Glass);
    const double b = dot(x, base::cast<double>(d)), root = b * b - lengthSq(x) + 1;
    if (!inside && (root < 0 || b > 0))
        return times(weight, scene.environment.from(d));
    if (bounces == 0)
        return times(weight, scene.environment.room(d));
    const double t = -b + (inside ? std::sqrt(root) : -std::sqrt(root));
    const Vec3d hit = normalized(x + base::cast<double>(d) * t);
    const Vec3f n = base::cast<float>(inside ? -hit : hit);
    const float eta = inside ? glass.index : 1 / glass.index;
    const Vec3f left =
        inside ? times(weight, transmitted(glass.absorption / scene.size, static_cast<float>(t))) : weight;
    const auto through = refracted(d, n, eta);
    float back = through ? reflectance(-dot(d, n), eta) : 1;
    if (scenes::largest(left) * back < leastPart)
        back = 0;
    const Vec3d in = hit * (1 - 1e-9), out = hit * (1 + 1e-9);
    Vec3f sum;
    if (back > 0)
        sum += byHand(scene, inside ? in : out, mirrored(d, n), inside, left * back, bounces - 1);
    if (through && back < 1)
        sum += byHand(scene, inside ? out : in, *through, !inside, left * (1 - back), bounces - 1);
    return sum;
}

/// Rays along -z at offsets that fill a disc.
static std::vector<base::Rayd> beam(double radius, int n) {
    std::vector<base::Rayd> out;
    for (int k = 0; k < n; ++k) {
        const double r = radius * std::sqrt((k + 0.5) / n), angle = 2.4 * k;
        out.push_back({{r * std::cos(angle), r * std::sin(angle), 3}, {0, 0, -1}});
    }
    return out;
}

void LightPathsTest::aGlassBallIsAsFollowedByHand() {
    const LightScene scene(ball(), scenes::lightingOf(Material::Glass), scenes::viewer());
    const auto rays = beam(0.97, test::effort(600));
    const auto light = scenes::lightAlong(scene, rays);
    std::size_t close = 0;
    double error = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3f d = base::cast<float>(rays[i].direction);
        // the first meeting is no bounce
        const Vec3f expected = byHand(scene, rays[i].origin, d, false, {1, 1, 1}, scene.lighting.bounces + 1);
        const float off = scenes::largest(light[i] - expected);
        error += static_cast<double>(off) / static_cast<double>(rays.size());
        close += off < 0.02f ? 1 : 0; // apart at the rims of lamps only
    }
    QVERIFY2(close * 100 >= 96 * rays.size() && error < 0.02,
             qPrintable(QString("%1 of %2 close, mean %3").arg(close).arg(rays.size()).arg(error)));
}

void LightPathsTest::lightOffTheMiddleIsAbsorbedLess() {
    // Of white surroundings everything is left but what the ways inside absorb: the chords grow towards the middle.
    raycast::Viewer white = scenes::viewer();
    white.top = white.bottom = {1, 1, 1};
    const LightScene scene(ball(), scenes::lightingOf(Material::Glass), white);
    const std::vector<base::Rayd> rays{{{0, 0, 3}, {0, 0, -1}}};
    const Vec3f middle = scenes::lightAlong(scene, rays).front();
    const Vec3f k = materialRow(Material::Glass).absorption / scene.size;
    // straight through twice 96 percent, by a way of 2
    for (const std::size_t c : {0u, 1u, 2u})
        QVERIFY2(std::abs(middle[c] - 0.96f * 0.96f * std::exp(-2 * k[c])) < 0.04f, qPrintable(QString::number(c)));
    QVERIFY(middle.x < middle.z && middle.z < middle.y); // green glass
}

void LightPathsTest::aMirrorBallShowsTheReflectedRoom() {
    const LightScene scene(ball(), scenes::lightingOf(Material::Metal), scenes::viewer());
    const auto rays = beam(0.95, 400);
    const auto light = scenes::lightAlong(scene, rays);
    std::size_t close = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3d x = rays[i].origin, n{x.x, x.y, std::sqrt(1 - x.x * x.x - x.y * x.y)};
        const Vec3f d = base::cast<float>(rays[i].direction), m = base::cast<float>(n);
        const Vec3f expected = times(metalReflectance(-dot(d, m), materialRow(Material::Metal).colour),
                                     scene.environment.from(mirrored(d, m)));
        close += scenes::largest(light[i] - expected) < 0.02f ? 1 : 0;
    }
    QVERIFY2(close * 100 >= 97 * rays.size(), qPrintable(QString::number(close)));
}

/// Rays that cross the plane z = 0 near its middle.
static std::vector<base::Rayd> slanting(double from) {
    std::vector<base::Rayd> out;
    for (const double x : {-0.8, -0.3, 0.0, 0.4, 1.0}) {
        const Vec3d d = normalized(Vec3d{x, 0.2, -from});
        out.push_back({-d, d});
    }
    return out;
}

void LightPathsTest::whatHasNoInsideIsAPane() {
    surfel::SurfelList strip = shapes::plane(60, 0.03, 0.1);
    strip.layout = shapes::layout(false, false); // as of a Moebius strip
    const LightScene scene(shapes::surfaceOf(strip), scenes::lightingOf(Material::Glass), scenes::viewer());
    QVERIFY(!scene.oriented);
    const MaterialRow& glass = materialRow(Material::Glass);
    for (const double side : {1.0, -1.0}) {
        const auto rays = slanting(side);
        const auto light = scenes::lightAlong(scene, rays);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Vec3f d = base::cast<float>(rays[i].direction), n{0, 0, d.z < 0 ? 1.0f : -1.0f};
            const float back = paneReflectance(-dot(d, n), 1 / glass.index);
            const Vec3f tint = transmitted(glass.absorption, 0.03f);
            const Vec3f expected =
                scene.environment.from(mirrored(d, n)) * back + times(scene.environment.from(d), tint) * (1 - back);
            QVERIFY2(scenes::largest(light[i] - expected) < 5e-3f, qPrintable(QString::number(i)));
        }
    }
}

void LightPathsTest::whereNothingLiesBehindItIsAPane() {
    // The front of an open surface: a ray that enters finds no way out, and goes on as if it had not been bent.
    const LightScene scene(shapes::surfaceOf(shapes::plane(60, 0.03, 0.1)), scenes::lightingOf(Material::Glass),
                           scenes::viewer());
    const auto rays = slanting(1);
    const auto light = scenes::lightAlong(scene, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3f d = base::cast<float>(rays[i].direction), n{0, 0, 1};
        const float back = reflectance(-dot(d, n), 1 / materialRow(Material::Glass).index);
        const Vec3f expected = scene.environment.from(mirrored(d, n)) * back + scene.environment.from(d) * (1 - back);
        QVERIFY2(scenes::largest(light[i] - expected) < 5e-3f, qPrintable(QString::number(i)));
    }
}

static const test::Registered<LightPathsTest> registered;
#include "light_paths_test.moc"
