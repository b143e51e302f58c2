#include "core/render/cast/raycast_image.h"

#include "core/render/splats/cpu_splatter.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "support/threads.h"

#include <atomic>
#include <QTest>

using namespace render;
using base::Vec3d;

class RaycastImageTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void planeIsMetAtItsDepth();
    void sphereIsMetAtItsDepthAndNowhereElse();
    void splatsAgreeWithTheTrueSurface();
    void coloursAreBlendedLikePositions();
    void sameBitsAtAnyThreadCount();
    void cancellingStopsIt();
};

static Camera smallCamera() {
    Camera camera;
    camera.width = 160;
    camera.height = 121;
    return camera;
}

static Image cast(const tree::SurfelTree& model, const Camera& camera, const RenderOptions& options = {}) {
    Image image;
    RayCounts counts;
    rayCast(surface::Surface(model, {}), camera, options, image, counts);
    if (counts.cast.rays != image.colour.size() || counts.cast.pixels != image.colour.size() ||
        !(counts.cast.seconds > 0))
        qFatal("counts are wrong");
    return image;
}

void RaycastImageTest::planeIsMetAtItsDepth() {
    const Vec3d normal = normalized(Vec3d{0.5, 0.3, 0.8});
    const Camera camera = smallCamera();
    const Image image = cast(test::built(test::disc({0, 0, 0}, normal, 4, 0.04)), camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
            const double expected = -dot(ray.origin, normal) / dot(ray.direction, normal);
            if (length(ray.at(expected)) < 3.5)
                QVERIFY(std::abs(image.depth[static_cast<std::size_t>(y * camera.width + x)] - expected) < 2e-5);
        }
}

void RaycastImageTest::sphereIsMetAtItsDepthAndNowhereElse() {
    const Camera camera = smallCamera();
    const Image image = cast(test::built(test::sphere({0.1, 0, -0.2}, 0.8, 20000)), camera);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const base::Rayd ray = camera.ray(x + 0.5, y + 0.5);
            const double depth = image.depth[static_cast<std::size_t>(y * camera.width + x)];
            if (std::isfinite(test::sphereDepth(ray, {0.1, 0, -0.2}, 0.79)))
                QVERIFY2(std::abs(depth - test::sphereDepth(ray, {0.1, 0, -0.2}, 0.8)) < 1e-3,
                         qPrintable(QString("%1 %2 %3").arg(x).arg(y).arg(depth)));
            else if (!std::isfinite(test::sphereDepth(ray, {0.1, 0, -0.2}, 0.805)))
                QVERIFY(std::isinf(depth));
        }
}

void RaycastImageTest::splatsAgreeWithTheTrueSurface() {
    const Camera camera = smallCamera();
    const auto model = test::built(test::torus(0.7, 0.25, 30000, test::seed()));
    CpuSplatter splatter;
    const Image splats = test::drawn(splatter, model, camera), rays = cast(model, camera);
    const test::Difference d = test::difference(splats, rays);
    // Discs stand out beyond an outline, here some 900 pixels long, by less than a pixel.
    QVERIFY2(d.mean < 2 && d.apart < 450,
             qPrintable(QString("mean %1, %2 pixels apart, seed %3").arg(d.mean).arg(d.apart).arg(test::seed())));
}

void RaycastImageTest::coloursAreBlendedLikePositions() {
    // A colour that is linear in the position is reproduced at the centroid, hence within o of the place itself.
    surfel::SurfelList list = test::disc({0, 0, 0}, {0, 0, 1}, 1, 0.02);
    list.layout = test::orientedLayout(true);
    for (auto& s : list.items) {
        s.colour = surfel::rgba(static_cast<unsigned>(127.5 + 120 * s.position.x), 40, 200);
        s.mask = 0.5f + 0.5f * s.position.y;
    }
    const surface::Surface surface(test::built(list), {});
    for (const float x : {-0.5f, 0.0f, 0.4f})
        for (const float y : {-0.3f, 0.2f}) {
            raycast::Sample sample;
            raycast::blendAttributes(surface, {x, y, 0}, sample);
            QVERIFY(std::abs(static_cast<float>(sample.colour & 255u) - (127.5f + 120 * x)) < 1.5f);
            QCOMPARE(sample.colour >> 8 & 255u, 40u);
            QVERIFY(std::abs(sample.mask - (0.5f + 0.5f * y)) < 2e-3f);
        }
}

void RaycastImageTest::sameBitsAtAnyThreadCount() {
    const auto model = test::built(test::torus(0.7, 0.25, 10000, test::seed()));
    const auto work = [&] { return cast(model, smallCamera()); };
    const Image one = test::onThreads(1, work), many = work();
    QVERIFY(one.colour == many.colour && one.depth == many.depth);
}

void RaycastImageTest::cancellingStopsIt() {
    const std::atomic<bool> stop{true};
    Image image;
    RayCounts counts;
    const surface::Surface surface(test::built(test::sphere({0, 0, 0}, 1, 1000)), {});
    QVERIFY_EXCEPTION_THROWN(rayCast(surface, smallCamera(), {}, image, counts, {{}, &stop}), base::Cancelled);
}

static const test::Registered<RaycastImageTest> registered;
#include "raycast_image_test.moc"
