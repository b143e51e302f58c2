// Parallel rays and clip planes: cameras, bounds, and the same picture however it is drawn.
#include "core/base/error.h"
#include "core/render/cast/raycast_image.h"
#include "core/render/splats/cpu_splatter.h"
#include "core/render/view_frame.h"
#include "render/boxes.h"
#include "render/render_models.h"
#include "support/registry.h"
#include "ui/gl/backends.h"
#include "ui/gl/offscreen_renderer.h"

#include <QTest>

using namespace render;
using base::Vec3d;

class ProjectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void parallelRaysAndPlacesUndoEachOther();
    void parallelFramingFillsTheImage();
    void boundsHoldTheirBoxInParallelToo();
    void whatIsCutAwayWasBehindAPlane();
    void keptPartsOfRaysAreKept();
    void aSphereOfParallelRaysIsACircleOfItsSize();
    void sameParallelAndClippedPictureOnBothBackends_data();
    void sameParallelAndClippedPictureOnBothBackends();
    void noPixelShowsWhatIsCutAway_data();
    void noPixelShowsWhatIsCutAway();
    void castRaysAgreeInSilhouette();
    void updatesFollowThePlane();
};

namespace {

Camera randomParallel(base::Random& random) {
    Camera camera;
    camera.eye = random.unitVector() * random.uniform(0.5, 20);
    camera.target = random.unitVector() * random.uniform(0, 3);
    camera.up = random.unitVector();
    camera.orthoHeight = random.uniform(0.1, 30);
    camera.width = 1 + static_cast<int>(random.below(2000));
    camera.height = 1 + static_cast<int>(random.below(2000));
    return camera;
}

QByteArray seeded(int round) {
    return QByteArray("round ") + QByteArray::number(round) + ", seed " + QByteArray::number(test::seed());
}

Camera smallCamera(const Vec3d& direction, double distance, double height) {
    Camera camera;
    camera.width = 320, camera.height = 240;
    camera.eye = base::normalized(direction) * distance;
    camera.orthoHeight = height;
    return camera;
}

base::Plane through(const Vec3d& normal, double offset) {
    return {base::normalized(normal), offset};
}

/// Where the pixel's depth says that it meets the model.
Vec3d placeOf(const Image& image, const Camera& camera, std::size_t i) {
    const auto x = static_cast<double>(i % static_cast<std::size_t>(image.width)),
               y = static_cast<double>(i / static_cast<std::size_t>(image.width));
    return camera.ray(x + 0.5, y + 0.5).at(static_cast<double>(image.depth[i]));
}

} // namespace

void ProjectionTest::parallelRaysAndPlacesUndoEachOther() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        const Camera camera = randomParallel(random);
        const double x = random.uniform(0, camera.width), y = random.uniform(0, camera.height);
        const base::Rayd ray = camera.ray(x, y);
        QVERIFY(distance(ray.direction, camera.forward()) < 1e-15);
        const double t = random.uniform(-50, 50);
        const Vec3d place = camera.project(ray.at(t));
        QVERIFY2(std::abs(place.x - x) < 1e-6 && std::abs(place.y - y) < 1e-6, seeded(k));
        QVERIFY2(std::abs(place.z - t) < 1e-9 * (1 + std::abs(t)), seeded(k));
    }
}

void ProjectionTest::parallelFramingFillsTheImage() {
    base::Random random(test::seed());
    for (int k = 0; k < 300; ++k) {
        base::Box3f box;
        for (int j = 0; j < 3; ++j)
            box.extend(base::cast<float>(random.unitVector() * random.uniform(1, 10)));
        const Camera before = randomParallel(random), camera = before.framing(box);
        QVERIFY2(distance(camera.forward(), before.forward()) < 1e-9, seeded(k));
        const double fill = test::filledBy(camera, box);
        QVERIFY2(fill > 0.9399 && fill < 0.9401, seeded(k));
    }
}

void ProjectionTest::boundsHoldTheirBoxInParallelToo() {
    base::Random random(test::seed());
    int seen = 0;
    for (int k = 0; k < 2000; ++k) {
        const Camera camera = randomParallel(random);
        base::Box3f box;
        for (int j = 0; j < 2; ++j)
            box.extend(base::cast<float>(camera.target + random.unitVector() * random.uniform(0.01, 10)));
        const auto reach = static_cast<float>(random.uniform(0, 1));
        QVERIFY2(test::boundsHold(camera, box, reach, random, seen), seeded(k));
    }
    QVERIFY(seen > 500);
}

/// A box that clip planes make invisible has no corner that they keep.
void ProjectionTest::whatIsCutAwayWasBehindAPlane() {
    base::Random random(test::seed());
    int cut = 0;
    for (int k = 0; k < 2000; ++k) {
        Camera camera = smallCamera(random.unitVector(), 10, k % 2 ? 12 : 0);
        camera.fovDeg = 90;
        base::Box3f box;
        for (int j = 0; j < 2; ++j)
            box.extend(base::cast<float>(random.unitVector() * random.uniform(0.1, 3)));
        const bool before = screenBounds(ViewFrame(camera), box, 0.1f).visible;
        camera.clips.add(through(random.unitVector(), random.uniform(-2, 2)));
        camera.clips.add(through(random.unitVector(), random.uniform(-2, 2)));
        if (!before || screenBounds(ViewFrame(camera), box, 0.1f).visible)
            continue;
        ++cut;
        for (int c = 0; c < 8; ++c)
            QVERIFY2(!camera.clips.keeps(test::corner(box, c)), seeded(k));
    }
    QVERIFY(cut > 200);
}

void ProjectionTest::keptPartsOfRaysAreKept() {
    base::Random random(test::seed());
    for (int k = 0; k < 1000; ++k) {
        ClipPlanes planes;
        for (int j = 0; j < 3; ++j)
            planes.add(through(random.unitVector(), random.uniform(-1, 1)));
        const base::Rayd ray{random.unitVector() * 2, random.unitVector()};
        const base::RayPart part = keptPart(ray, planes.all());
        for (int j = 0; j < 20; ++j) {
            const double t = random.uniform(0, 6);
            const bool inside = t >= part.first && t <= part.second;
            const bool edge = std::abs(t - part.first) < 1e-9 || std::abs(t - part.second) < 1e-9;
            QVERIFY2(edge || inside == planes.keeps(ray.at(t)), seeded(k));
        }
    }
}

void ProjectionTest::aSphereOfParallelRaysIsACircleOfItsSize() {
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 40000));
    CpuSplatter cpu;
    for (const double distance : {2.0, 500.0, -2.0}) { // how far the eye is does not show; < 0: cast rays
        const Camera camera = smallCamera({1, 2, -0.5}, std::abs(distance), 3);
        Image image;
        RayCounts counts;
        if (distance < 0)
            rayCast(surface::Surface(model, {}), camera, {}, image, counts);
        else
            cpu.render(model, camera, {}, image);
        double area = 0;
        for (std::size_t i = 0; i < image.depth.size(); ++i) {
            if (!std::isfinite(image.depth[i]))
                continue;
            area += 1;
            const auto x = static_cast<double>(i % 320), y = static_cast<double>(i / 320);
            const double expected = test::sphereDepth(camera.ray(x + 0.5, y + 0.5), {0, 0, 0}, 1);
            if (std::isfinite(expected) && expected < std::abs(distance) - 0.3)
                QVERIFY(std::abs(static_cast<double>(image.depth[i]) - expected) < 2e-3);
        }
        const double radiusPx = std::sqrt(area / 3.14159265358979);
        // The splats' filter reaches a pixel beyond the outline.
        QVERIFY2(std::abs(radiusPx - 80) < (distance < 0 ? 0.1 : 1.2), qPrintable(QString::number(radiusPx)));
    }
}

void ProjectionTest::sameParallelAndClippedPictureOnBothBackends_data() {
    QTest::addColumn<QString>("backend");
    QTest::addColumn<double>("height");
    QTest::addColumn<int>("planes");
    QTest::addColumn<bool>("oriented");
    QTest::addColumn<float>("pointLimit");
    for (const char* backend : {"osmesa", "egl"}) {
        QTest::addRow("%s parallel", backend) << backend << 3.0 << 0 << true << 1e9f;
        QTest::addRow("%s parallel, near", backend) << backend << 0.2 << 0 << true << 20.0f;
        QTest::addRow("%s parallel, unoriented", backend) << backend << 2.5 << 0 << false << 1e9f;
        QTest::addRow("%s clipped", backend) << backend << 0.0 << 1 << true << 1e9f;
        QTest::addRow("%s clipped by six", backend) << backend << 0.0 << 6 << true << 20.0f;
        QTest::addRow("%s parallel, clipped", backend) << backend << 2.5 << 2 << true << 1e9f;
    }
}

void ProjectionTest::sameParallelAndClippedPictureOnBothBackends() {
    QFETCH(QString, backend);
    QFETCH(double, height);
    QFETCH(int, planes);
    QFETCH(bool, oriented);
    QFETCH(float, pointLimit);
    std::unique_ptr<OffscreenRenderer> gl;
    try {
        gl = std::make_unique<OffscreenRenderer>(backend == "egl" ? makeEglContext() : makeOsMesaContext());
    } catch (const base::Error& e) {
        QSKIP(e.what());
    }
    gl->limitPointSize(pointLimit);
    surfel::SurfelList list = test::sphere({0, 0, 0}, 1, 20000);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->oriented = oriented;
    list.layout = layout;
    const tree::SurfelTree model = test::built(list);
    const Vec3d normals[] = {{1, 1, -0.3}, {-1, 0.2, -1}, {0, -1, 0.5}, {0.3, 0, 1}, {0, 1, 0}, {-1, -1, 0}};
    CpuSplatter cpu;
    for (const Vec3d& direction : {Vec3d{1, 2, 3}, Vec3d{-2, 0.1, -1}, Vec3d{0.2, -3, 0.5}}) {
        Camera camera = smallCamera(direction, 3, height);
        for (int k = 0; k < planes; ++k)
            camera.clips.add(through(normals[k], planes > 2 ? -0.7 : -0.2));
        const Image a = test::drawn(cpu, model, camera), b = test::drawn(*gl, model, camera);
        const test::Difference d = test::difference(a, b);
        QVERIFY2(d.mean < 0.5 && d.apart <= 25,
                 qPrintable(QString("mean %1, largest %2, apart %3").arg(d.mean).arg(d.largest).arg(d.apart)));
        QVERIFY(std::count_if(a.depth.begin(), a.depth.end(), [](float t) { return std::isfinite(t); }) > 5000);
    }
}

void ProjectionTest::noPixelShowsWhatIsCutAway_data() {
    QTest::addColumn<bool>("rays");
    QTest::addColumn<double>("height");
    for (const double height : {0.0, 2.6}) {
        QTest::addRow("splats, height %g", height) << false << height;
        QTest::addRow("rays, height %g", height) << true << height;
    }
}

void ProjectionTest::noPixelShowsWhatIsCutAway() {
    QFETCH(bool, rays);
    QFETCH(double, height);
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 20000));
    for (const base::Plane& plane : {through({0, 0, -1}, -0.4), through({1, 0.5, 0.2}, 0.1), through({0, 0, 1}, 0.3)}) {
        Camera camera = smallCamera({0.1, 0.2, 1}, 3.5, height);
        camera.clips.add(plane);
        Image image;
        RayCounts counts;
        if (rays)
            rayCast(surface::Surface(model, {}), camera, {}, image, counts);
        else
            image = test::drawn(*makeRenderer("cpu"), model, camera);
        // A splat's depth is a mean of its layer's: within a small part of the splats' size.
        const double tolerance = rays ? 1e-5 : 0.03;
        int shown = 0, inside = 0;
        for (std::size_t i = 0; i < image.depth.size(); ++i) {
            if (!std::isfinite(image.depth[i]))
                continue;
            const Vec3d p = placeOf(image, camera, i);
            QVERIFY(plane.distance(p) > -tolerance);
            QVERIFY(std::abs(length(p) - 1) < 0.1);
            ++shown;
            inside += dot(p, camera.forward()) > 0.2 ? 1 : 0;
        }
        QVERIFY(shown > 2000);
        if (plane.normal.z < -0.5) // looking into the bowl
            QVERIFY(inside > 1000);
    }
}

void ProjectionTest::castRaysAgreeInSilhouette() {
    const tree::SurfelTree model = test::built(test::torus(1, 0.4, 20000, test::seed()));
    CpuSplatter cpu;
    for (const bool clipped : {false, true}) {
        Camera camera = smallCamera({0.3, 1, 0.6}, 4, 3.2);
        if (clipped)
            camera.clips.add(through({1, -0.2, 0.1}, -0.2));
        const Image splats = test::drawn(cpu, model, camera);
        Image cast;
        RayCounts counts;
        rayCast(surface::Surface(model, {}), camera, {}, cast, counts);
        const test::Difference d = test::difference(splats, cast);
        std::size_t covered = 0;
        for (const float depth : cast.depth)
            covered += std::isfinite(depth) ? 1 : 0;
        QVERIFY2(d.apart < covered / 25 && covered > 5000,
                 qPrintable(QString("%1 apart of %2").arg(d.apart).arg(covered)));
    }
}

void ProjectionTest::updatesFollowThePlane() {
    const tree::SurfelTree model = test::built(test::sphere({0, 0, 0}, 1, 5000));
    Camera camera = smallCamera({0, 0, 1}, 3, 0);
    CpuSplatter moving, fresh;
    Image image;
    moving.render(model, camera, {}, image);
    for (int k = 0; k < 4; ++k) {
        camera.clips = {};
        camera.clips.add(through({1, 0, 0}, -0.5 + 0.3 * k));
        moving.update(model, camera, {}, image);
        QVERIFY(image.colour == test::drawn(fresh, model, camera).colour);
    }
}

static const test::Registered<ProjectionTest> registered;
#include "projection_test.moc"
