#include "core/base/random.h"
#include "core/base/ray.h"
#include "support/registry.h"

#include <QTest>

using namespace base;

class BoxRayTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void emptyBoxContainsNothingAndGrowsToWhatItIsGiven();
    void distanceIsThatOfTheNearestPoint();
    void clippedIntervalIsInsideAndItsEndsAreOnTheBox();
    void rayInAFacePlaneIsNotLost();
    void perpendicularIsUnitAndPerpendicular();
};

static Vec3d randomPoint(Random& random, double reach) {
    return {random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

void BoxRayTest::emptyBoxContainsNothingAndGrowsToWhatItIsGiven() {
    Box3d box;
    QVERIFY(box.empty());
    QVERIFY(!box.contains({0, 0, 0}));
    QCOMPARE(box.distanceSq({0, 0, 0}), Box3d::inf);
    box.extend(Vec3d{1, 2, 3});
    QVERIFY(!box.empty() && box.lo == box.hi && box.contains({1, 2, 3}));
    box.extend(Box3d{});
    QVERIFY((box.lo == Vec3d{1, 2, 3}));
}

void BoxRayTest::distanceIsThatOfTheNearestPoint() {
    Random random(test::seed());
    const Box3d box{{-1, -2, -0.5}, {1, 2, 0.5}};
    for (int k = 0; k < 2000; ++k) {
        const Vec3d p = randomPoint(random, 4), q = randomPoint(random, 4);
        const double claimed = box.distanceSq(p);
        if (box.contains(q))
            QVERIFY2(claimed <= distanceSq(p, q) + 1e-12, qPrintable(QString("seed %1").arg(test::seed())));
        QCOMPARE(claimed == 0, box.contains(p));
    }
}

void BoxRayTest::clippedIntervalIsInsideAndItsEndsAreOnTheBox() {
    Random random(test::seed());
    const Box3d box{{-1, -2, -0.5}, {1, 2, 0.5}}, slack = box.inflated(1e-9), core = box.inflated(-1e-9);
    int hits = 0;
    for (int k = 0; k < 4000; ++k) {
        const Rayd ray{randomPoint(random, 4), random.unitVector()};
        const auto [t0, t1] = clip(ray, box);
        for (double t = 0; t < 12; t += 0.05)
            QVERIFY2(!core.contains(ray.at(t)) || (t >= t0 && t <= t1),
                     "a point inside the box is inside the interval");
        if (t0 > t1)
            continue;
        ++hits;
        QVERIFY(slack.contains(ray.at(t0)) && slack.contains(ray.at(t1)));
    }
    QVERIFY(hits > 100);
}

void BoxRayTest::rayInAFacePlaneIsNotLost() {
    const Box3d box{{0, 0, 0}, {1, 1, 1}};
    const auto [t0, t1] = clip(Rayd{{-1, 0, 0.5}, {1, 0, 0}}, box);
    QCOMPARE(t0, 1.0);
    QCOMPARE(t1, 2.0);
    const auto [m0, m1] = clip(Rayd{{-1, -0.1, 0.5}, {1, 0, 0}}, box);
    QVERIFY(m0 > m1);
}

void BoxRayTest::perpendicularIsUnitAndPerpendicular() {
    Random random(test::seed());
    for (int k = 0; k < 1000; ++k) {
        const Vec3d n = k == 0 ? Vec3d{0, 0, -1} : random.unitVector();
        const Vec3d u = perpendicular(n);
        QVERIFY(std::abs(dot(n, u)) < 1e-14 && std::abs(length(u) - 1) < 1e-14);
    }
}

static const test::Registered<BoxRayTest> registered;
#include "box_ray_test.moc"
