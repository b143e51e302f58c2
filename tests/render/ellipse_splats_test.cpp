// Splats of supports that are ellipsoids: true ellipses in space.
#include "core/render/splats/cpu_splatter.h"
#include "core/render/splats/splat_scale.h"
#include "core/surfel/shape.h"
#include "render/render_models.h"
#include "support/registry.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class EllipseSplatsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void anEllipseCoversWhatItsShapeSays();
    void ballsAsEllipsoidsAreDiscs();
    void aShapeOutOfThePlaneCountsInThePlane();
    void splatsAreScaledByTheAreaOfSupports();
};

static surfel::SurfelList withShapes(const surfel::SurfelList& list, const std::vector<base::Vec3f>& shapes) {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    surfel::addShape(*layout);
    out.layout = layout;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
        std::vector<std::uint32_t> words(layout->words());
        surfel::putShape(words, surfel::shapeWord(*layout), shapes[i % shapes.size()]);
        out.append(list.items[i], words);
    }
    return out;
}

/// One splat that stands at the origin.
static surfel::SurfelList one(const Vec3d& normal, double radius) {
    surfel::SurfelList out;
    out.layout = test::orientedLayout();
    out.items.push_back(
        {{}, base::cast<float>(normal), static_cast<float>(radius) / splatRadiusOfSupport, surfel::white, 0});
    return out;
}

static Camera cameraOf(bool parallel) {
    Camera camera = test::cutTilesCamera();
    camera.orthoHeight = parallel ? 1.9 : 0;
    return camera;
}

void EllipseSplatsTest::anEllipseCoversWhatItsShapeSays() {
    base::Random random(test::seed());
    CpuSplatter splatter;
    for (int k = 0; k < 24; ++k) {
        Vec3d n = random.unitVector();
        n.z = 0.3 + std::abs(n.z); // not edge-on
        n = normalized(n);
        const double radius = random.uniform(0.2, 0.5), aspect = random.uniform(1, double(surfel::mostAspect));
        const Vec3d e = normalized(cross(n, random.unitVector())), b = e * std::sqrt(aspect * aspect - 1);
        const Camera camera = cameraOf(k % 2 == 1);
        const Image image =
            test::drawn(splatter, test::built(withShapes(one(n, radius), {base::cast<float>(b)})), camera);
        int inside = 0, wrong = 0;
        for (int y = 0; y < camera.height; ++y)
            for (int x = 0; x < camera.width; ++x) {
                const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
                const Vec3d q =
                    ray.origin - ray.direction * (dot(ray.origin, n) / dot(ray.direction, n)); // on the plane
                const double r = std::sqrt(lengthSq(q) + dot(b, q) * dot(b, q)) / radius;
                if (std::abs(r - 1) < 0.01 || length(camera.project(q) - camera.project({})) < 2)
                    continue; // the rim, and the pixel of the filter
                const std::size_t i = std::size_t(y) * std::size_t(camera.width) + std::size_t(x);
                wrong += std::isfinite(image.depth[i]) != (r < 1);
                inside += r < 1;
            }
        QVERIFY2(wrong == 0, qPrintable(QString("%1 pixels, case %2, seed %3").arg(wrong).arg(k).arg(test::seed())));
        QVERIFY(inside > 50);
    }
}

void EllipseSplatsTest::ballsAsEllipsoidsAreDiscs() {
    const surfel::SurfelList list = test::torus(0.7, 0.3, 4000, test::seed());
    CpuSplatter splatter;
    for (const bool parallel : {false, true}) {
        const Image discs = test::drawn(splatter, test::built(list), cameraOf(parallel));
        const Image ellipses = test::drawn(splatter, test::built(withShapes(list, {{}})), cameraOf(parallel));
        QVERIFY(discs.colour == ellipses.colour);
        QVERIFY(discs.depth == ellipses.depth);
    }
}

/// b stays as it is where something turns the normal.
void EllipseSplatsTest::aShapeOutOfThePlaneCountsInThePlane() {
    const Vec3d n = normalized(Vec3d{0.3, -0.2, 1});
    const Vec3d b = normalized(cross(n, Vec3d{1, 0, 0})) * 2;
    CpuSplatter splatter;
    const auto covered = [&](const Vec3d& shape) {
        const Image image = test::drawn(splatter, test::built(withShapes(one(n, 0.4), {base::cast<float>(shape)})),
                                        test::cutTilesCamera());
        return std::count_if(image.depth.begin(), image.depth.end(), [](float z) { return std::isfinite(z); });
    };
    const auto flat = covered(b), tilted = covered(b + n * 1.5);
    QVERIFY(flat > 500);
    QVERIFY2(std::abs(flat - tilted) <= 2, qPrintable(QString("%1 %2").arg(flat).arg(tilted)));
}

/// As few neighbours, as much scale, whatever the shape.
void EllipseSplatsTest::splatsAreScaledByTheAreaOfSupports() {
    surfel::SurfelList balls = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.02), ellipsoids = balls;
    for (surfel::Surfel& s : balls.items)
        s.support *= 0.45f;
    for (surfel::Surfel& s : ellipsoids.items)
        s.support *= 0.45f * std::sqrt(2.0f); // the long axis where a1 / a2 = 2
    const float wanted = splatScaleOf(test::built(balls));
    QVERIFY(wanted > 1.2f);
    QCOMPARE(splatScaleOf(test::built(withShapes(ellipsoids, {{0, std::sqrt(3.0f), 0}}))), wanted);
}

static const test::Registered<EllipseSplatsTest> registered;
#include "ellipse_splats_test.moc"
