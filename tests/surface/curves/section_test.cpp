// Plane sections: curves that theory knows, points that fulfil both equations, ends at boundaries, agreement with rays.
#include "core/surface/curves/section.h"

#include "core/base/parallel.h"
#include "core/surface/rays/intersect.h"
#include "support/registry.h"
#include "surface/bounded.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Plane, base::Vec3d;

class SectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void spheresAreCutInCircles();
    void exactSpheresAreCutInExactCircles();
    void toriAreCutInTwoCirclesOrVillarceaus();
    void planesAreCutInLinesThatEndAtTheRim();
    void pointsFulfilBothEquations();
    void raysInThePlaneFindTheSameCurve();
    void touchingIsNoSection();
    void planesBesideTheModelCutNothing();
    void unorientedStripsAreCutToo();
    void threadsDoNotShow();
};

namespace {

Plane through(const Vec3d& normal, const Vec3d& p) {
    const Vec3d n = base::normalized(normal);
    return {n, dot(n, p)};
}

QString described(const std::vector<SectionCurve>& curves) {
    QString out = QString("seed %1, %2 curves:").arg(test::seed()).arg(curves.size());
    for (const SectionCurve& curve : curves)
        out +=
            QString(" %1 %2 (%3)").arg(curve.closed ? "closed" : "open").arg(curve.length()).arg(curve.points.size());
    return out;
}

} // namespace

void SectionTest::spheresAreCutInCircles() {
    const double s = shapes::sphereSpacing(4000, 1), h = 3.5 * s;
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, h), {});
    for (const double d : {0.0, 0.3, -0.8}) {
        const Plane plane{base::normalized(Vec3d{1, 2, 3}), d};
        const auto curves = findSection(surface, plane);
        QVERIFY2(curves.size() == 1 && curves[0].closed, qPrintable(described(curves)));
        const double radius = std::sqrt(1 - d * d);
        QVERIFY2(std::abs(curves[0].length() - 2 * shapes::pi * radius) < 2e-3 * radius, qPrintable(described(curves)));
        QVERIFY(std::abs(curves[0].area(plane) - shapes::pi * radius * radius) < 1e-2); // counter-clockwise
        for (const SectionPoint& p : curves[0].points) {
            QVERIFY(std::abs(length(p.position) - 1) < 0.02 * h);
            QVERIFY(distance(p.normal, p.position) < 0.05);
        }
    }
}

/// What apss fits to surfels of a sphere is the sphere itself, to the floats' rounding.
void SectionTest::exactSpheresAreCutInExactCircles() {
    const double h = 3.5 * shapes::sphereSpacing(4000, 1);
    SurfaceDefinition definition;
    definition.frame = Frame::Apss;
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, h), definition);
    const Plane plane{base::normalized(Vec3d{-1, 0.5, 2}), 0.4};
    const auto curves = findSection(surface, plane);
    QVERIFY2(curves.size() == 1 && curves[0].closed, qPrintable(described(curves)));
    const Vec3d middle = plane.normal * 0.4;
    for (const SectionPoint& p : curves[0].points) {
        QVERIFY(std::abs(distance(p.position, middle) - std::sqrt(1 - 0.16)) < 1e-6 * h);
        QVERIFY(distance(p.along, base::normalized(cross(plane.normal, p.position - middle))) < 1e-5);
    }
    QVERIFY(std::abs(curves[0].length() - 2 * shapes::pi * std::sqrt(1 - 0.16)) < 1e-5);
}

void SectionTest::toriAreCutInTwoCirclesOrVillarceaus() {
    const double major = 1, minor = 0.4, s = 0.03, h = 3.5 * s;
    const Surface surface = shapes::surfaceOf(shapes::torus(major, minor, s, h), {});
    const auto equator = findSection(surface, {{0, 0, 1}, 0});
    QVERIFY2(equator.size() == 2 && equator[0].closed && equator[1].closed, qPrintable(described(equator)));
    QVERIFY(std::abs(equator[0].length() - 2 * shapes::pi * 1.4) < 0.01);
    QVERIFY(std::abs(equator[1].length() - 2 * shapes::pi * 0.6) < 0.01);
    const Plane flat{{0, 0, 1}, 0};
    QVERIFY(equator[0].area(flat) > 0 && equator[1].area(flat) < 0); // a hole runs the other way round

    const auto meridians = findSection(surface, {{1, 0, 0}, 0});
    QVERIFY2(meridians.size() == 2, qPrintable(described(meridians)));
    for (const SectionCurve& curve : meridians)
        QVERIFY(curve.closed && std::abs(curve.length() - 2 * shapes::pi * minor) < 0.01);

    // The bitangent plane cuts Villarceau's two circles of radius `major`, which meet where it touches. A little beside
    // it they part there, on one side the one way and on the other the other, into one figure that follows both.
    const double tilt = std::asin(minor / major);
    const Plane bitangent{{std::sin(tilt), 0, std::cos(tilt)}, 5e-4};
    const auto circles = findSection(surface, bitangent);
    QVERIFY2(circles.size() == 1 && circles[0].closed, qPrintable(described(circles)));
    QVERIFY2(std::abs(circles[0].length() - 4 * shapes::pi * major) < 0.25, qPrintable(described(circles)));
    for (const SectionPoint& p : circles[0].points) {
        const double off = std::min(std::abs(distance(p.position, {0, minor, 0}) - major),
                                    std::abs(distance(p.position, {0, -minor, 0}) - major));
        QVERIFY2(off < 0.02, qPrintable(QString::number(off)));
    }
}

void SectionTest::planesAreCutInLinesThatEndAtTheRim() {
    const double s = 0.05, h = 3.5 * s;
    const Surface surface = shapes::surfaceOf(shapes::plane(20, s, h), shapes::bounded(0.25f));
    const Plane plane = through({1, 0.2, 0.3}, {0.1, 0, 0});
    const auto curves = findSection(surface, plane);
    QVERIFY2(curves.size() == 1 && !curves[0].closed, qPrintable(described(curves)));
    for (const SectionPoint& p : curves[0].points)
        QVERIFY(std::abs(p.position.z) < 1e-9 && std::abs(plane.distance(p.position)) < 1e-15);
    for (const Vec3d& end : {curves[0].points.front().position, curves[0].points.back().position}) {
        const Evaluationd at = surface.evaluateReference(end);
        QVERIFY2(std::abs(at.offCentre - 0.25 * at.unit) < 1e-6 * at.unit,
                 qPrintable(QString::number(at.offCentre / at.unit)));
    }
}

/// Random planes through a bumpy shape: every corner lies on both, to what float64 can tell.
void SectionTest::pointsFulfilBothEquations() {
    base::Random random(test::seed());
    const double s = 0.04, h = 3.5 * s;
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, s, h), 0.2 * s, test::seed()), {});
    std::size_t points = 0;
    for (int k = 0; k < 12; ++k) {
        const Plane plane = through(random.unitVector(), random.unitVector() * random.uniform(0, 0.8));
        for (const SectionCurve& curve : findSection(surface, plane)) {
            QVERIFY2(curve.closed, qPrintable(QString("seed %1, round %2").arg(test::seed()).arg(k)));
            for (const SectionPoint& p : curve.points) {
                const Evaluationd at = surface.evaluateReference(p.position);
                QVERIFY(std::abs(at.value) < 1e-9 * h && std::abs(plane.distance(p.position)) < 1e-15);
                QVERIFY(std::abs(dot(p.along, plane.normal)) < 1e-12 && std::abs(dot(p.along, p.normal)) < 1e-12);
            }
            for (std::size_t i = 1; i < curve.points.size(); ++i)
                QVERIFY(distance(curve.points[i].position, curve.points[i - 1].position) < 0.4 * h);
            points += curve.points.size();
        }
    }
    QVERIFY(points > 500);
}

/// Brute force: all hits of rays inside the plane lie on the curves, and none of the curves is missed.
void SectionTest::raysInThePlaneFindTheSameCurve() {
    base::Random random(test::seed());
    const double s = 0.04, h = 3.5 * s;
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, s, h), {});
    const Plane plane = through(random.unitVector(), random.unitVector() * 0.3);
    const auto curves = findSection(surface, plane);
    const Vec3d u = base::perpendicular(plane.normal), v = cross(plane.normal, u), middle = plane.normal * plane.offset;
    int hits = 0;
    for (int k = 0; k < 60; ++k) {
        const Vec3d start = middle + u * random.uniform(-1.2, 1.2) - v * 4.0;
        for (const auto& hit : intersectAllReference(surface, {start, v})) {
            double nearest = 1e9;
            for (const SectionCurve& curve : curves)
                for (std::size_t i = 0; i < curve.points.size(); ++i) {
                    const Vec3d a = curve.points[i].position, b = curve.points[(i + 1) % curve.points.size()].position;
                    const double part = std::clamp(dot(hit.position - a, b - a) / lengthSq(b - a), 0.0, 1.0);
                    nearest = std::min(nearest, distance(hit.position, a + (b - a) * part));
                }
            QVERIFY2(nearest < 0.01 * h, qPrintable(QString("%1 h off, %2").arg(nearest / h).arg(described(curves))));
            ++hits;
        }
    }
    QVERIFY2(hits > 20, qPrintable(QString("%1 hits, seed %2").arg(hits).arg(test::seed())));
}

void SectionTest::touchingIsNoSection() {
    const Surface surface = shapes::surfaceOf(shapes::plane(10, 0.05, 0.175), {});
    QVERIFY(findSection(surface, {{0, 0, 1}, 0}).empty());
}

void SectionTest::planesBesideTheModelCutNothing() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(2000, 1, 0.3), {});
    QVERIFY(findSection(surface, {{0, 0, 1}, 5}).empty());
    QVERIFY(findSection(Surface{}, {{0, 0, 1}, 0}).empty());
}

void SectionTest::unorientedStripsAreCutToo() {
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    list.layout = shapes::layout(true, false);
    base::Random random(test::seed());
    for (surfel::Surfel& each : list.items)
        if (random.below(2))
            each.normal = -each.normal;
    const auto curves = findSection(shapes::surfaceOf(list, {}), {{0, 1, 0}, 0.2});
    QVERIFY2(curves.size() == 1 && curves[0].closed, qPrintable(described(curves)));
    QVERIFY(std::abs(curves[0].length() - 2 * shapes::pi * std::sqrt(1 - 0.04)) < 0.01);
}

void SectionTest::threadsDoNotShow() {
    const double h = 3.5 * shapes::sphereSpacing(3000, 1);
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::sphere(3000, 1, h), 0.01, 3), {});
    const Plane plane{{0.6, 0, 0.8}, 0.1};
    const auto bits = [&](int threads) {
        base::setThreadCount(threads);
        std::vector<double> out;
        for (const SectionCurve& curve : findSection(surface, plane))
            for (const SectionPoint& p : curve.points)
                out.insert(out.end(), {p.position.x, p.position.y, p.position.z, p.along.x});
        base::setThreadCount(0);
        return out;
    };
    QVERIFY(bits(1) == bits(3));
}

static const test::Registered<SectionTest> registered;
#include "section_test.moc"
