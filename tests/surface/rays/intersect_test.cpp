// Ray intersection: the first root in every ray, none where there is none.
#include "core/surface/rays/intersect.h"

#include "core/surface/projection/project.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class IntersectTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void spheresAreHitFirstUpToTheirSilhouette_data();
    void spheresAreHitFirstUpToTheirSilhouette();
    void raysBesideMiss();
    void tiltedPlanesAreExact();
    void raysInThePlaneMiss();
    void hitsBeforeTMinArePassedOver();
    void hitsBeyondTMaxDoNotCount();
    void rangesThatEndJustBehindAHitKeepIt();
    void noisyModelsLoseNoHitOfTheRobustMarch_data();
    void noisyModelsLoseNoHitOfTheRobustMarch();
    void reversedRaysFindTheSamePoint();
    void midSheetsOfPlatesAreNoSurface();
    void boundariesEndTheSurface();
    void unorientedSurfacesAreHitFromBothSides();
    void batchGivesTheBitsOfSingles();
    void nearZeroDirectionsAndEmptyModelsMiss();
    void raysEndFromAnyDistance_data();
    void raysEndFromAnyDistance();
};

static base::Rayd towards(const Vec3d& target, const Vec3d& direction, double from) {
    return {target - direction * from, direction};
}
static base::Rayf cast(const base::Rayd& ray) {
    return {base::cast<float>(ray.origin), base::cast<float>(ray.direction)};
}

void IntersectTest::spheresAreHitFirstUpToTheirSilhouette_data() {
    QTest::addColumn<bool>("robust");
    QTest::addColumn<bool>("shrinkFree");
    QTest::addColumn<int>("frame");
    for (const bool robust : {false, true})
        for (const bool shrinkFree : {false, true})
            for (const Frame frame : {Frame::Normals, Frame::Hyperplanes, Frame::CovarianceAtCentroid})
                QTest::addRow("robust=%d mu=%d frame=%d", robust, shrinkFree, static_cast<int>(frame))
                    << robust << shrinkFree << static_cast<int>(frame);
}

/// The figures of surface/README 4.3: 2000 points, h = 3.5 s, first root for b/rho up to 0.995, misses at 1.02
/// detected.
void IntersectTest::spheresAreHitFirstUpToTheirSilhouette() {
    QFETCH(bool, robust);
    QFETCH(bool, shrinkFree);
    QFETCH(int, frame);
    SurfaceDefinition definition;
    definition.shrinkFree = shrinkFree;
    definition.frame = static_cast<Frame>(frame);
    const double h = 3.5 * shapes::sphereSpacing(2000, 1);
    const Surface surface = shapes::surfaceOf(shapes::sphere(2000, 1, h), definition);
    const double rho = length(projectReference(surface, {0.4, 0.5, 0.6}).foot);
    IntersectOptions options;
    options.robust = robust;
    base::Random random(test::seed());
    for (const double part : {0.0, 0.2, 0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 1.02})
        for (int i = 0; i < 8; ++i) {
            const Vec3d d = random.unitVector(), side = base::normalized(cross(d, random.unitVector()));
            const base::Rayd ray = towards(side * (part * rho), d, 5);
            const RayHit<double> hit = intersectReference(surface, ray, options);
            const RayHit<float> fast = intersect(surface, cast(ray), options);
            const QString where = QString("b/rho %1, round %2, seed %3").arg(part).arg(i).arg(test::seed());
            QVERIFY2(hit.hit == (part < 1) && fast.hit == hit.hit, qPrintable(where));
            if (!hit.hit)
                continue;
            const double expected = 5 - rho * std::sqrt(1 - part * part);
            const double slack = 1e-3 / std::sqrt(1 - part * part); // ripple of 2000 points, stretched by the angle
            QVERIFY2(std::abs(hit.t - expected) < slack, qPrintable(where + QString(": %1").arg(hit.t - expected)));
            QVERIFY2(std::abs(double(fast.t) - hit.t) < 1e-4 * h / (1.001 - part), qPrintable(where));
            QVERIFY(std::abs(surface.evaluateReference(hit.position, Need::Value).value) < 1e-11);
            QVERIFY(dot(hit.normal, d) < 0 && dot(hit.outward, hit.position) > 0.99 * rho);
        }
}

void IntersectTest::raysBesideMiss() {
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.3, 0.05, 0.17));
    QVERIFY(!intersect(surface, {{0, 0, 5}, {0, 0, -1}}).hit); // through the hole
    QVERIFY(!intersect(surface, {{0, 0, 5}, {0, 0, 1}}).hit);  // away
    QVERIFY(!intersect(surface, {{3, 0, 5}, {0, 0, -1}}).hit);
}

void IntersectTest::tiltedPlanesAreExact() {
    const Surface surface = shapes::surfaceOf(shapes::plane(20, 0.1, 0.35, 0.25));
    base::Random random(test::seed());
    for (int i = 0; i < 200; ++i) {
        const Vec3d target{random.uniform(-1, 1), random.uniform(-1, 1), 0.25};
        Vec3d d = random.unitVector();
        if (std::abs(d.z) < 0.03)
            continue;
        const RayHit<double> hit = intersectReference(surface, towards(target, d, 3));
        // a flat ray may enter from beyond the edge of the sheet, which bounds nothing
        QVERIFY(hit.hit);
        QVERIFY2(distance(hit.position, target) < 1e-9, qPrintable(QString::number(d.z)));
        const RayHit<float> fast = intersect(surface, cast(towards(target, d, 3)));
        QVERIFY(fast.hit && distance(base::cast<double>(fast.position), target) < 2e-6 / std::abs(d.z));
    }
}

void IntersectTest::raysInThePlaneMiss() {
    SurfaceDefinition definition;
    definition.boundaryLimit = 0.3f;
    const Surface surface = shapes::surfaceOf(shapes::plane(10, 0.1, 0.35), definition);
    QVERIFY(!intersectReference(surface, {{-5, 0, 0.01}, {1, 0, 0}}).hit);
    QVERIFY(!intersect(surface, {{-5, 0, 0.01f}, {1, 0, 0}}).hit);
}

void IntersectTest::hitsBeforeTMinArePassedOver() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, 0.2));
    const base::Rayf ray{{0.1f, 0.2f, 5}, {0, 0, -1}};
    const RayHit<float> front = intersect(surface, ray);
    IntersectOptions behind;
    behind.tMin = front.t + 0.01f;
    const RayHit<float> back = intersect(surface, ray, behind);
    QVERIFY(front.hit && back.hit);
    QVERIFY(std::abs(front.position.z + back.position.z) < 1e-3f);
    QVERIFY(dot(front.outward, front.normal) > 0.99f && dot(back.outward, back.normal) < -0.99f);
    behind.tMin = back.t + 0.01f;
    QVERIFY(!intersect(surface, ray, behind).hit);
    // a ray from inside
    QVERIFY(std::abs(intersect(surface, {{0, 0, 0}, {1, 0, 0}}).t - 1) < 1e-3f);
}

void IntersectTest::hitsBeyondTMaxDoNotCount() {
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, 0.2));
    IntersectOptions options;
    options.tMax = 3.99f;
    QVERIFY(!intersect(surface, {{0, 0, 5}, {0, 0, -1}}, options).hit);
    options.tMax = 4.01f;
    QVERIFY(intersect(surface, {{0, 0, 5}, {0, 0, -1}}, options).hit);
}

/// From inside a ball the tangent discs that lead to the surface lie behind it.
void IntersectTest::rangesThatEndJustBehindAHitKeepIt() {
    const double s = shapes::sphereSpacing(4000, 1);
    const Surface surface = shapes::surfaceOf(shapes::sphere(4000, 1, 3.5 * s));
    base::Random random(test::seed());
    for (int i = 0; i < 2000; ++i) {
        const base::Rayf ray = cast({random.unitVector() * random.uniform(0, 0.4), random.unitVector()});
        const RayHit<float> free = intersect(surface, ray);
        const auto told = [&] { return qPrintable(QString("seed %1, ray %2").arg(test::seed()).arg(i)); };
        QVERIFY2(free.hit, told());
        IntersectOptions options;
        for (const double behind : {1e-3, 0.02, 0.5}) {
            options.tMax = free.t + static_cast<float>(behind * s);
            const RayHit<float> hit = intersect(surface, ray, options);
            QVERIFY2(hit.hit && std::abs(hit.t - free.t) < 1e-4 * s, told());
            QVERIFY2(intersectAny(surface, ray, options), told());
        }
        options.tMax = free.t - static_cast<float>(0.02 * s);
        QVERIFY2(!intersect(surface, ray, options).hit, told());
    }
}

void IntersectTest::noisyModelsLoseNoHitOfTheRobustMarch_data() {
    QTest::addColumn<bool>("oriented");
    QTest::addRow("oriented") << true;
    QTest::addRow("unoriented") << false;
}

void IntersectTest::noisyModelsLoseNoHitOfTheRobustMarch() {
    QFETCH(bool, oriented);
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, test::seed());
    list.layout = shapes::layout(true, oriented);
    const Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed() + 1);
    IntersectOptions robust;
    robust.robust = true;
    int hits = 0, lost = 0, other = 0;
    const int rays = 1500;
    for (int i = 0; i < rays; ++i) {
        const Vec3d target = random.unitVector() * random.uniform(0, 1.4), d = random.unitVector();
        const base::Rayf ray = cast(towards(target, d, 4));
        const RayHit<float> slow = intersect(surface, ray, robust), fast = intersect(surface, ray);
        hits += slow.hit;
        lost += slow.hit && !fast.hit;
        other += slow.hit && fast.hit && std::abs(slow.t - fast.t) > 1e-3f;
        QVERIFY2(slow.hit || !fast.hit, "the fast way found what marching did not");
    }
    const QString report = QString("%1 hits, %2 lost, %3 elsewhere").arg(hits).arg(lost).arg(other);
    QVERIFY2(hits > rays / 4 && lost == 0 && other <= 1, qPrintable(report));
}

void IntersectTest::reversedRaysFindTheSamePoint() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, 5));
    base::Random random(test::seed());
    int compared = 0;
    for (int i = 0; i < 300; ++i) {
        const base::Rayd ray = towards(random.unitVector() * random.uniform(0, 1.2), random.unitVector(), 4);
        const RayHit<double> hit = intersectReference(surface, ray);
        if (!hit.hit || std::abs(dot(hit.outward, ray.direction)) < 0.2)
            continue;
        const RayHit<double> back = intersectReference(surface, {hit.position + ray.direction * -0.1, ray.direction});
        const RayHit<double> reversed =
            intersectReference(surface, {hit.position + ray.direction * 0.02, -ray.direction});
        QVERIFY(back.hit && distance(back.position, hit.position) < 1e-9);
        QVERIFY(reversed.hit && distance(reversed.position, hit.position) < 1e-9);
        ++compared;
    }
    QVERIFY(compared > 100);
}

void IntersectTest::midSheetsOfPlatesAreNoSurface() {
    for (const double thickness : {3.0, 2.0, 1.5, 1.0})
        for (const bool oriented : {true, false}) {
            if (!oriented && thickness < 3)
                continue; // without orientation near sheets are one
            const double s = 0.1, h = 0.35, half = 0.5 * thickness * s;
            surfel::SurfelList list = shapes::plates(15, s, h, 2 * half);
            list.layout = shapes::layout(true, oriented);
            const Surface surface = shapes::surfaceOf(list);
            for (const double tilt : {0.0, 0.5, 1.0}) {
                const Vec3d d = base::normalized(Vec3d{tilt, 0.1 * tilt, -1});
                double from = 0;
                std::vector<double> heights;
                for (int k = 0; k < 4; ++k) {
                    IntersectOptions options;
                    options.tMin = static_cast<float>(from);
                    const RayHit<double> hit = intersectReference(surface, towards({0.03, 0.02, 0}, d, 2), options);
                    if (!hit.hit)
                        break;
                    heights.push_back(hit.position.z);
                    from = hit.t + 1e-3 * s;
                }
                const QString where =
                    QString("thickness %1 tilt %2 hits %3").arg(thickness).arg(tilt).arg(heights.size());
                QVERIFY2(heights.size() == 2, qPrintable(where));
                if (oriented)
                    QVERIFY2(std::abs(heights[0] - half) < 1e-3 * s && std::abs(heights[1] + half) < 1e-3 * s,
                             qPrintable(where));
            }
        }
}

void IntersectTest::boundariesEndTheSurface() {
    SurfaceDefinition definition;
    definition.boundary = Boundary::Limit;
    definition.boundaryLimit = 0.3f;
    const double s = 0.01, h = 0.2;
    const Surface surface = shapes::surfaceOf(shapes::plane(60, s, h), definition);
    const double edge = 60.5 * s + 0.130 * h; // surface/README 5.1
    for (const double x : {edge - 0.02 * h, edge + 0.02 * h}) {
        const RayHit<float> hit = intersect(surface, cast({{x, 0, 2}, {0, 0, -1}}));
        QCOMPARE(hit.hit, x < edge);
    }
}

void IntersectTest::unorientedSurfacesAreHitFromBothSides() {
    // a Moebius strip: no orientation exists
    surfel::SurfelList list;
    list.layout = shapes::layout(true, false);
    for (int i = 0; i < 240; ++i)
        for (int j = -9; j <= 9; ++j) {
            const double a = 2 * shapes::pi * i / 240, r = 0.027 * j;
            const Vec3d ring{std::cos(a), std::sin(a), 0},
                across = ring * std::cos(a / 2) + Vec3d{0, 0, std::sin(a / 2)};
            const Vec3d along{-std::sin(a), std::cos(a), 0};
            list.items.push_back(shapes::surfelAt(ring + across * r, base::normalized(cross(along, across)), 0.095));
        }
    SurfaceDefinition definition;
    definition.boundaryLimit = 0.3f;
    const Surface surface = shapes::surfaceOf(list, definition);
    base::Random random(test::seed());
    for (int i = 0; i < 300; ++i) {
        const surfel::Surfel& s = list.items[random.below(240) * 19 + 4 + random.below(11)];
        const Vec3d p = base::cast<double>(s.position), n = base::cast<double>(s.normal);
        const Vec3d d = base::normalized(n + random.unitVector() * 0.5);
        const RayHit<float> a = intersect(surface, cast(towards(p, d, 0.1)));
        const RayHit<float> b = intersect(surface, cast(towards(p, -d, 0.1)));
        QVERIFY(a.hit && b.hit);
        QVERIFY(distance(a.position, b.position) < 1e-5f && distance(base::cast<double>(a.position), p) < 0.01);
    }
}

void IntersectTest::batchGivesTheBitsOfSingles() {
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, 5));
    base::Random random(test::seed());
    std::vector<base::Rayf> rays;
    for (int i = 0; i < 1000; ++i)
        rays.push_back(cast(towards(random.unitVector() * random.uniform(0, 1.4), random.unitVector(), 4)));
    std::vector<RayHit<float>> out(rays.size());
    intersect(surface, rays, {}, out);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const RayHit<float> single = intersect(surface, rays[i]);
        QVERIFY(out[i].hit == single.hit && out[i].t == single.t && out[i].normal == single.normal);
    }
}

void IntersectTest::nearZeroDirectionsAndEmptyModelsMiss() {
    QVERIFY(!intersect(Surface(), {{0, 0, 0}, {0, 0, 1}}).hit);
    const Surface surface = shapes::surfaceOf(shapes::sphere(500, 1, 0.4));
    QVERIFY(!intersect(surface, {{0, 0, 0}, {0, 0, 0}}).hit);
}

void IntersectTest::raysEndFromAnyDistance_data() {
    QTest::addColumn<bool>("robust");
    QTest::addColumn<bool>("oriented");
    for (const bool robust : {false, true})
        for (const bool oriented : {false, true})
            QTest::addRow("robust=%d oriented=%d", robust, oriented) << robust << oriented;
}

/// From where floats cannot tell the model's front from its back, and doubles cannot, either. Every search comes to an
/// end; as long as doubles can, the first hit is that of a start near by.
void IntersectTest::raysEndFromAnyDistance() {
    QFETCH(bool, robust);
    QFETCH(bool, oriented);
    surfel::SurfelList list = shapes::sphere(500, 1, 0.4);
    if (!oriented)
        list.layout = shapes::layout(true, false);
    const Surface surface = shapes::surfaceOf(list);
    IntersectOptions options;
    options.robust = robust;
    for (const float from : {1e2f, 3e3f, 3e4f, 1e5f, 1e7f, 1e8f, 1e9f, 1e12f, 1e15f, 1e17f, 1.8446744e19f, 1e30f}) {
        const base::Rayf ray{{0.3f, 0.1f, from}, {0, 0, -1}};
        const RayHit<float> hit = intersect(surface, ray, options);
        const auto all = intersectAll(surface, ray, options);
        const auto exact = intersectAllReference(
            surface, {base::cast<double>(ray.origin), base::cast<double>(ray.direction)}, options);
        const bool any = intersectAny(surface, ray, options);
        const QByteArray where = QByteArray::number(from);
        if (from <= 1e9f) {
            QVERIFY2(hit.hit && any && std::abs(hit.position.z - std::sqrt(0.9f)) < 0.01f, where.constData());
            QVERIFY2(all.size() == 2 && exact.size() == 2, where.constData());
        }
        for (const RayHit<float>& each : all)
            QVERIFY2(std::abs(length(each.position) - 1) < 0.01f, where.constData());
    }
}

static const test::Registered<IntersectTest> registered;
#include "intersect_test.moc"
