#include "ui/orbit_view.h"

#include "core/base/random.h"
#include "support/registry.h"
#include "ui/render/named_views.h"

#include <numbers>
#include <QtTest>

using namespace ui;
using base::Vec3d;

class OrbitViewTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cameraAndViewAreInverse();
    void orbitKeepsTheTargetInThePicture();
    void panFollowsThePointer();
    void zoomKeepsThePivotInPlace();
    void namedViewsLookAlongTheAxes();
    void framingShowsTheWholeBox();
};

static OrbitView randomView(base::Random& random) {
    OrbitView out;
    out.target = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    out.distance = std::pow(10.0, random.uniform(-3, 3));
    out.yawRad = random.uniform(-3.1, 3.1);
    out.pitchRad = random.uniform(-1.5, 1.5);
    return out;
}

void OrbitViewTest::cameraAndViewAreInverse() {
    base::Random random(test::seed());
    for (int k = 0; k < 500; ++k) {
        OrbitView view = randomView(random);
        if (k % 10 == 0)
            view.pitchRad = (k % 20 ? 1 : -1) * std::numbers::pi / 2; // straight down and up
        const OrbitView back = OrbitView::of(view.camera(640, 480));
        QVERIFY(base::length(back.target - view.target) < 1e-12);
        QVERIFY(std::abs(back.distance - view.distance) < 1e-9 * view.distance);
        QVERIFY(std::abs(back.pitchRad - view.pitchRad) < 1e-7);
        QVERIFY2(std::abs(std::remainder(back.yawRad - view.yawRad, 2 * std::numbers::pi)) < 1e-6,
                 qPrintable(QString("round %1, seed %2").arg(k).arg(test::seed())));
    }
}

void OrbitViewTest::orbitKeepsTheTargetInThePicture() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        OrbitView view = randomView(random);
        const double distance = view.distance;
        view.orbit(random.uniform(-900, 900), random.uniform(-900, 900), 600);
        const auto camera = view.camera(800, 600);
        const Vec3d at = camera.project(view.target);
        QVERIFY(std::abs(at.x - 400) < 1e-6 && std::abs(at.y - 300) < 1e-6);
        QVERIFY(std::abs(base::length(camera.eye - camera.target) - distance) < 1e-9 * distance);
        QVERIFY(camera.upright().y > -1e-9); // never upside down
    }
}

void OrbitViewTest::panFollowsThePointer() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        OrbitView view = randomView(random);
        const Vec3d before = view.target;
        const double dx = random.uniform(-200, 200), dy = random.uniform(-200, 200);
        view.pan(dx, dy, 600);
        const Vec3d at = view.camera(800, 600).project(before);
        QVERIFY(std::abs(at.x - 400 - dx) < 1e-6 && std::abs(at.y - 300 - dy) < 1e-6);
    }
}

void OrbitViewTest::zoomKeepsThePivotInPlace() {
    base::Random random(test::seed());
    for (int k = 0; k < 200; ++k) {
        OrbitView view = randomView(random);
        const auto before = view.camera(800, 600);
        const auto ray = before.ray(random.uniform(0, 800), random.uniform(0, 600));
        const Vec3d pivot = ray.at(view.distance * random.uniform(0.5, 2));
        view.zoom(random.uniform(-5, 5), pivot);
        const Vec3d was = before.project(pivot), is = view.camera(800, 600).project(pivot);
        QVERIFY(std::abs(was.x - is.x) < 1e-6 && std::abs(was.y - is.y) < 1e-6);
    }
    OrbitView view;
    const double distance = view.distance;
    view.zoom(1, view.target);
    QVERIFY(view.distance < distance);
}

void OrbitViewTest::namedViewsLookAlongTheAxes() {
    const Vec3d expected[] = {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
    QCOMPARE(render::namedViews().size(), std::size(expected));
    for (std::size_t i = 0; i < std::size(expected); ++i) {
        const render::NamedView& row = render::namedViews()[i];
        OrbitView view;
        view.turnTo(row.toEye, row.up);
        QVERIFY(base::length(view.camera(100, 100).forward() - expected[i]) < 1e-12);
        QVERIFY(base::length(view.camera(100, 100).upright() - row.up) < 1e-12);
    }
}

void OrbitViewTest::framingShowsTheWholeBox() {
    base::Random random(test::seed());
    const base::Box3f boxes[] = {{{-1, -2, 3}, {0, 5, 4}}, {{-1, -2, 3}, {4, 0, 7}}};
    for (int k = 0; k < 100; ++k) {
        OrbitView view = randomView(random);
        const double yaw = view.yawRad;
        view.frame(boxes, 800, 500);
        QCOMPARE(view.yawRad, yaw);
        QVERIFY(view.target == (Vec3d{1.5, 1.5, 5}));
        double farthest = 0; // from the middle, as a part of what fits
        for (const base::Box3f& box : boxes)
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3d p{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                              corner & 4 ? box.hi.z : box.lo.z};
                const Vec3d at = view.camera(800, 500).project(p);
                QVERIFY(at.z > 0);
                farthest = std::max({farthest, std::abs(at.x - 400) / 400, std::abs(at.y - 250) / 250});
            }
        QVERIFY2(std::abs(farthest - 0.92) < 1e-9, qPrintable(QString::number(farthest)));
    }
}

static const test::Registered<OrbitViewTest> registered;
#include "orbit_view_test.moc"
