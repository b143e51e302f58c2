#include "core/render/camera.h"

#include "core/base/random.h"
#include "core/render/view_frame.h"
#include "render/boxes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using render::Camera;

class CameraTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void rayAndProjectUndoEachOther();
    void theMiddleOfTheImageIsTheTarget();
    void axesAreOrthonormalEvenWhenLookingAlongUp();
    void framedBoxesFillTheImageAndStayInside();
    void framingAPointKeepsTheDistance();
    void screenBoundsHoldTheirBox();
};

static Camera randomCamera(base::Random& random) {
    Camera camera;
    camera.eye = random.unitVector() * random.uniform(0.5, 20);
    camera.target = random.unitVector() * random.uniform(0, 3);
    camera.up = random.unitVector();
    camera.fovDeg = random.uniform(5, 100);
    camera.width = 1 + static_cast<int>(random.below(2000));
    camera.height = 1 + static_cast<int>(random.below(2000));
    return camera;
}

static QByteArray seeded(int round) {
    return QByteArray("round ") + QByteArray::number(round) + ", seed " + QByteArray::number(test::seed());
}

void CameraTest::rayAndProjectUndoEachOther() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        const Camera camera = randomCamera(random);
        const double x = random.uniform(0, camera.width), y = random.uniform(0, camera.height);
        const base::Rayd ray = camera.ray(x, y);
        QVERIFY(std::abs(length(ray.direction) - 1) < 1e-12);
        const double t = random.uniform(0.1, 50);
        const Vec3d place = camera.project(ray.at(t));
        QVERIFY2(std::abs(place.x - x) < 1e-6 && std::abs(place.y - y) < 1e-6, seeded(k));
        QVERIFY2(std::abs(place.z - t * dot(ray.direction, camera.forward())) < 1e-9 * t, seeded(k));
    }
}

void CameraTest::theMiddleOfTheImageIsTheTarget() {
    Camera camera;
    camera.eye = {3, 2, 5};
    camera.target = {1, -1, 0};
    const Vec3d place = camera.project(camera.target);
    QVERIFY(std::abs(place.x - 640) < 1e-9 && std::abs(place.y - 360) < 1e-9);
    QVERIFY(camera.project(camera.target + Vec3d{0, 0.1, 0}).y < 360); // up is up
    QVERIFY(camera.project(camera.target + camera.right()).x > 640);   // right is right
}

void CameraTest::axesAreOrthonormalEvenWhenLookingAlongUp() {
    for (const Vec3d& up : {Vec3d{0, 1, 0}, Vec3d{0, -1, 0}, Vec3d{0, 0, 0}, Vec3d{1e-12, 1, 0}}) {
        Camera camera;
        camera.eye = {0, 5, 0};
        camera.up = up;
        const Vec3d f = camera.forward(), r = camera.right(), u = camera.upright();
        for (const Vec3d& axis : {f, r, u})
            QVERIFY(std::abs(length(axis) - 1) < 1e-9);
        QVERIFY(std::abs(dot(f, r)) < 1e-9 && std::abs(dot(f, u)) < 1e-9 && std::abs(dot(r, u)) < 1e-9);
    }
}

static base::Box3f randomBox(base::Random& random) {
    base::Box3f box;
    const Vec3d centre = random.unitVector() * random.uniform(0, 100);
    for (int k = 0; k < 3; ++k)
        box.extend(base::cast<float>(centre + random.unitVector() * random.uniform(0.01, 10)));
    return box;
}

void CameraTest::framedBoxesFillTheImageAndStayInside() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        const Camera before = randomCamera(random);
        const base::Box3f box = randomBox(random);
        const Camera camera = before.framing(box);
        QVERIFY2(length(camera.forward() - before.forward()) < 1e-9, seeded(k));
        const double fill = test::filledBy(camera, box);
        QVERIFY2(fill > 0.9399 && fill < 0.9401, seeded(k));
    }
}

void CameraTest::framingAPointKeepsTheDistance() {
    Camera camera;
    base::Box3f point;
    point.extend(base::Vec3f{7, 8, 9});
    const Camera framed = camera.framing(point);
    QCOMPARE(length(framed.eye - framed.target), 3.0);
    QVERIFY(framed.target == (Vec3d{7, 8, 9}));
    QVERIFY(camera.framing({}) == camera);
}

void CameraTest::screenBoundsHoldTheirBox() {
    base::Random random(test::seed());
    int seen = 0;
    for (int k = 0; k < 2000; ++k) {
        Camera camera = randomCamera(random);
        const base::Box3f box = randomBox(random);
        camera.target = base::cast<double>(box.centre()) + random.unitVector();
        const float reach = static_cast<float>(random.uniform(0, 1));
        QVERIFY2(test::boundsHold(camera, box, reach, random, seen), seeded(k));
    }
    QVERIFY(seen > 1000);
}

static const test::Registered<CameraTest> registered;
#include "camera_test.moc"
