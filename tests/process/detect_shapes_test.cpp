// Shapes among many points: found, counted and told as they were made, whatever stands beside them.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/process/measuring/detect_shapes.h"
#include "support/registry.h"
#include "support/threads.h"

#include <cmath>
#include <numbers>
#include <QTest>

using base::Vec3d;
using process::DetectedShapes, process::DetectWish, process::Shape;

class DetectShapesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sidesOfABoxAreItsPlanes();
    void eachShapeIsFoundAsItWasMade();
    void densityAndPlaceMakeNoDifference();
    void strayPointsBelongToNone();
    void shapesThatDoNotHangTogetherAreTwo();
    void whatHardlyBendsIsNoSphere();
    void noShapeIsSmallerThanAskedFor();
    void theSameAtAnyThreadCount();
    void whatCannotBeToldIsRefused();
};

namespace {

surfel::SurfelList emptyList() {
    surfel::SurfelList out;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    out.layout = layout;
    return out;
}

void add(surfel::SurfelList& list, const Vec3d& x, const Vec3d& n, double noise, base::Random& random) {
    surfel::Surfel s;
    s.position = base::cast<float>(x + n * (noise * random.normal()));
    s.normal = base::cast<float>(n);
    list.items.push_back(s);
    list.extra.resize(list.size() * list.layout->words());
}

/// A rectangle of extents 2 u, 2 v; `squeeze` packs points to one end of u, up to 20 times as dense.
void addRectangle(surfel::SurfelList& list, const Vec3d& centre, const Vec3d& u, const Vec3d& v, int count,
                  double noise, base::Random& random, double squeeze = 1) {
    for (int k = 0; k < count; ++k) {
        const double a = 2 * std::pow(random.uniform(), squeeze) - 1, b = random.uniform(-1, 1);
        add(list, centre + u * a + v * b, base::normalized(cross(u, v)), noise, random);
    }
}

surfel::SurfelList box(int perSide, double noise, base::Random& random, double squeeze = 1, const Vec3d& at = {}) {
    surfel::SurfelList out = emptyList();
    const Vec3d e[3] = {{1, 0, 0}, {0, 0.7, 0}, {0, 0, 0.5}};
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            addRectangle(out, at + e[axis] * side, e[(axis + 1) % 3] * side, e[(axis + 2) % 3], perSide, noise, random,
                         squeeze);
    return out;
}

double away(const Vec3d& a, const Vec3d& b) { // of lines
    return length(cross(base::normalized(a), base::normalized(b)));
}

} // namespace

void DetectShapesTest::sidesOfABoxAreItsPlanes() {
    base::Random random(test::seed());
    for (const double noise : {0.0, 0.004}) {
        const surfel::SurfelList list = box(test::effort(2500), noise, random);
        const DetectedShapes found = process::detectShapes(list, {});
        const QString where = QString("noise %1, seed %2").arg(noise).arg(test::seed());
        QVERIFY2(found.shapes.size() == 6, qPrintable(where + QString(": %1 shapes").arg(found.shapes.size())));
        std::size_t on = 0;
        for (const auto& each : found.shapes) {
            QVERIFY2(each.primitive.shape == Shape::Plane, qPrintable(where));
            const Vec3d n = each.primitive.axis;
            QVERIFY2(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) > 1 - 1e-5, qPrintable(where));
            QVERIFY2(each.rms < 1.2 * noise + 1e-6, qPrintable(where));
            on += each.points;
        }
        QVERIFY2(static_cast<double>(on) > 0.98 * static_cast<double>(list.size()), qPrintable(where));
    }
}

/// A plate that carries a ball, a pipe, a cone and a ring, apart from each other, turned by chance.
void DetectShapesTest::eachShapeIsFoundAsItWasMade() {
    base::Random random(test::seed());
    const int count = test::effort(4000);
    const Vec3d z = random.unitVector(), x = base::normalized(cross(z, random.unitVector())), y = cross(z, x);
    const auto turned = [&](const Vec3d& p) { return x * p.x + y * p.y + z * p.z; };
    surfel::SurfelList list = emptyList();
    addRectangle(list, {}, x * 4.0, y * 4.0, 3 * count, 0.002, random);
    const double angle = 0.4;
    for (int k = 0; k < count; ++k) {
        const double t = random.uniform(0, 2 * std::numbers::pi), s = random.uniform(0, 2 * std::numbers::pi);
        const Vec3d out{std::cos(t), std::sin(t), 0};
        const Vec3d ball = random.unitVector();
        add(list, turned(Vec3d{2, 2, 2} + ball * 0.8), turned(ball), 0.002, random);
        add(list, turned(Vec3d{-2, 2, random.uniform(1, 3)} + out * 0.5), turned(out), 0.002, random);
        const double far = std::sqrt(random.uniform(0.04, 1)) * 2;
        add(list, turned(Vec3d{2, -2, 3 - far * std::cos(angle)} + out * (far * std::sin(angle))),
            turned(out * std::cos(angle) + Vec3d{0, 0, std::sin(angle)}), 0.002, random);
        const Vec3d tube = out * std::cos(s) + Vec3d{0, 0, std::sin(s)};
        add(list, turned(Vec3d{-2, -2, 2} + out * 0.8 + tube * 0.25), turned(tube), 0.002, random);
    }
    DetectWish wish;
    wish.shapes = {Shape::Plane, Shape::Sphere, Shape::Cylinder, Shape::Cone, Shape::Torus};
    wish.fewest = static_cast<std::size_t>(count) / 2;
    const DetectedShapes found = process::detectShapes(list, wish);
    const QString where = QString("seed %1, %2 shapes").arg(test::seed()).arg(found.shapes.size());
    QVERIFY2(found.shapes.size() == 5, qPrintable(where));
    int seen = 0;
    for (const auto& each : found.shapes) {
        const process::Primitive& p = each.primitive;
        seen |= 1 << static_cast<int>(p.shape);
        const QString which = QString("%1: shape %2").arg(where).arg(static_cast<int>(p.shape));
        if (p.shape != Shape::Sphere)
            QVERIFY2(away(p.axis, z) < 5e-3, qPrintable(which));
        if (p.shape == Shape::Sphere)
            QVERIFY2(length(p.place - turned({2, 2, 2})) < 2e-3 && std::abs(p.radius - 0.8) < 2e-3, qPrintable(which));
        if (p.shape == Shape::Cylinder)
            QVERIFY2(std::abs(p.radius - 0.5) < 2e-3, qPrintable(which));
        if (p.shape == Shape::Cone)
            QVERIFY2(std::abs(p.angle - angle) < 5e-3 && length(p.place - turned({2, -2, 3})) < 0.02,
                     qPrintable(which));
        if (p.shape == Shape::Torus)
            QVERIFY2(std::abs(p.radius - 0.8) < 5e-3 && std::abs(p.tube - 0.25) < 5e-3, qPrintable(which));
        if (p.shape != Shape::Plane)
            QVERIFY2(std::abs(static_cast<double>(each.points) / count - 1) < 0.05, qPrintable(which));
    }
    QCOMPARE(seen, 31);
}

/// 20 times as dense at one end, and where float32 holds a hundredth of a spacing.
void DetectShapesTest::densityAndPlaceMakeNoDifference() {
    base::Random random(test::seed());
    for (const auto& [squeeze, far] : {std::pair{2.5, 0.0}, {1.0, 3000.0}}) {
        const surfel::SurfelList list = box(test::effort(2500), 0, random, squeeze, {far, -far, far});
        const DetectedShapes found = process::detectShapes(list, {});
        std::size_t on = 0;
        for (const auto& each : found.shapes)
            on += each.primitive.shape == Shape::Plane ? each.points : 0;
        QVERIFY2(found.shapes.size() == 6 && static_cast<double>(on) > 0.95 * static_cast<double>(list.size()),
                 qPrintable(QString("%1 shapes with %2 points, squeezed %3, at %4, seed %5")
                                .arg(found.shapes.size())
                                .arg(on)
                                .arg(squeeze)
                                .arg(far)
                                .arg(test::seed())));
    }
}

void DetectShapesTest::strayPointsBelongToNone() {
    base::Random random(test::seed());
    surfel::SurfelList list = box(test::effort(2000), 0, random);
    const std::size_t good = list.size();
    for (std::size_t k = 0; k < good / 4; ++k)
        add(list, {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)}, random.unitVector(), 0,
            random);
    const DetectedShapes found = process::detectShapes(list, {});
    QVERIFY2(found.shapes.size() == 6, qPrintable(QString("%1, seed %2").arg(found.shapes.size()).arg(test::seed())));
    std::size_t kept = 0, strays = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
        (i < good ? kept : strays) += found.shapeOf[i] > 0;
    QVERIFY2(static_cast<double>(kept) > 0.97 * static_cast<double>(good), qPrintable(QString::number(kept)));
    QVERIFY2(static_cast<double>(strays) < 0.05 * static_cast<double>(list.size() - good),
             qPrintable(QString::number(strays)));
}

void DetectShapesTest::shapesThatDoNotHangTogetherAreTwo() {
    base::Random random(test::seed());
    surfel::SurfelList list = emptyList();
    const int count = test::effort(3000);
    addRectangle(list, {-2, 0, 0}, {1, 0, 0}, {0, 1, 0}, count, 0, random);
    addRectangle(list, {2, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2 * count, 0, random);
    const DetectedShapes found = process::detectShapes(list, {});
    QCOMPARE(found.shapes.size(), std::size_t(2));
    for (std::size_t i = 0; i < list.size(); ++i)
        QCOMPARE(found.shapeOf[i], list.items[i].position.x > 0 ? 1u : 2u);
}

/// A wall that a scanner has bent by a few degrees.
void DetectShapesTest::whatHardlyBendsIsNoSphere() {
    base::Random random(test::seed());
    surfel::SurfelList list = emptyList();
    for (int k = 0; k < test::effort(5000); ++k) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        add(list, {x, y, 0.03 * (x * x + y * y)}, base::normalized(Vec3d{-0.06 * x, -0.06 * y, 1}), 0.004, random);
    }
    for (const auto& each : process::detectShapes(list, {}).shapes)
        QCOMPARE(each.primitive.shape, Shape::Plane);
}

void DetectShapesTest::noShapeIsSmallerThanAskedFor() {
    base::Random random(test::seed());
    surfel::SurfelList list = emptyList();
    const int count = test::effort(3000);
    addRectangle(list, {}, {2, 0, 0}, {0, 2, 0}, count, 0, random);
    addRectangle(list, {0, 0, 1}, {0.5, 0, 0}, {0, 0.5, 0}, count / 5, 0, random);
    DetectWish wish;
    for (const int fewest : {count / 10, count / 3, 2 * count}) {
        wish.fewest = static_cast<std::size_t>(fewest);
        QCOMPARE(process::detectShapes(list, wish).shapes.size(),
                 std::size_t(fewest < count / 5) + std::size_t(fewest < count));
    }
}

void DetectShapesTest::theSameAtAnyThreadCount() {
    base::Random random(test::seed());
    const surfel::SurfelList list = box(test::effort(1500), 0.01, random);
    const auto found = [&] { return process::detectShapes(list, {}); };
    const DetectedShapes one = test::onThreads(1, found), three = test::onThreads(3, found);
    QVERIFY(one.shapeOf == three.shapeOf && one.shapes.size() == three.shapes.size());
    for (std::size_t k = 0; k < one.shapes.size(); ++k)
        QVERIFY(one.shapes[k].rms == three.shapes[k].rms &&
                one.shapes[k].primitive.place == three.shapes[k].primitive.place);
}

void DetectShapesTest::whatCannotBeToldIsRefused() {
    base::Random random(test::seed());
    surfel::SurfelList list = box(200, 0, random);
    auto bare = std::make_shared<surfel::AttributeLayout>(*list.layout);
    bare->normals = bare->oriented = false;
    surfel::SurfelList without = list;
    without.layout = bare;
    QVERIFY_EXCEPTION_THROWN(process::detectShapes(without, {}), base::Error);
    list.items.resize(9);
    QVERIFY_EXCEPTION_THROWN(process::detectShapes(list, {}), base::Error);
    std::atomic<bool> cancel = true;
    QVERIFY_EXCEPTION_THROWN(process::detectShapes(box(200, 0, random), {}, {{}, &cancel}), base::Cancelled);
}

static const test::Registered<DetectShapesTest> registered;
#include "detect_shapes_test.moc"
