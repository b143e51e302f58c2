// Ellipsoidal supports on surfaces that are known, and under affine maps.
#include "core/surface/curvature.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"
#include "support/registry.h"
#include "surface/ellipsoids.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f, base::Mat3d;

class KnownEllipsoidsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void mapsThatMakeThemBallsKeepTheSums();
    void planesAreExact();
    void spheresStaySpheres();
    void raysMeetSpheres();
};

/// Where all have one shape, the map that stretches along it makes them balls.
void KnownEllipsoidsTest::mapsThatMakeThemBallsKeepTheSums() {
    base::Random random(test::seed());
    const surfel::SurfelList plain = shapes::jittered(shapes::torus(1, 0.4, 0.08, 0.4), 0.01, test::seed());
    for (int round = 0; round < 5; ++round) {
        const Vec3d b = random.unitVector() * random.uniform(0.2, 3);
        const Vec3d e = base::normalized(b);
        const Mat3d map = Mat3d::identity() + base::outer(e, e) * (std::sqrt(1 + lengthSq(b)) - 1);
        const Surface shaped =
            shapes::surfaceOf(shapes::shaped(plain, [&](const surfel::Surfel&) { return base::cast<float>(b); }));
        surfel::SurfelList moved = plain;
        for (surfel::Surfel& s : moved.items)
            s.position = base::cast<float>(map * base::cast<double>(s.position));
        const Surface balls = shapes::surfaceOf(moved);
        for (int i = 0; i < test::effort(50); ++i) {
            const Vec3d x = base::cast<double>(shapes::beside(plain, random, 0.2)), y = map * x;
            SumOptions options;
            Moments<double, 1> there;
            sum(ScratchClusters(balls.tree(), y).span(), y, options, there);
            options.shape = surfel::shapeChannel(*shaped.tree().layout());
            Moments<double, 1> here;
            sum(ScratchClusters(shaped.tree(), x).span(), x, options, here);
            if (there.one.v < 1e-3)
                continue;
            // positions were rounded to float
            QVERIFY(std::abs(here.one.v - there.one.v) < 1e-5 * there.one.v);
            const Vec3d centroid = valueOf(there.q) / there.one.v;
            QVERIFY(distance(map * (valueOf(here.q) / here.one.v), centroid) < 1e-5);
            const Vec3d slope{there.one.d[0], there.one.d[1], there.one.d[2]};
            QVERIFY(distance(Vec3d{here.one.d[0], here.one.d[1], here.one.d[2]}, map * slope) <
                    1e-4 * (length(slope) + there.one.v / 0.4));
        }
    }
}

/// f is the height, whatever the shapes.
void KnownEllipsoidsTest::planesAreExact() {
    const surfel::SurfelList list = shapes::ellipsoids(shapes::plane(10, 0.1, 0.3), 3.3, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed());
    for (int i = 0; i < 200; ++i) {
        const Vec3d x{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.03, 0.03)};
        const Evaluationd e = surface.evaluateReference(x, Need::Hessian);
        QVERIFY(e.ok());
        QVERIFY(std::abs(e.value - x.z) < 1e-12);
        QVERIFY(distance(e.gradient, Vec3d{0, 0, 1}) < 1e-11);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(std::abs(e.hessian.m[r][c]) < 1e-8);
    }
}

/// Every term of the shrink-free form vanishes on a sphere with its own normals, whatever the weights.
void KnownEllipsoidsTest::spheresStaySpheres() {
    const surfel::SurfelList list = shapes::ellipsoids(shapes::sphere(4000, 1, 0.15), 3, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed());
    std::vector<Vec3f> from;
    for (int i = 0; i < test::effort(400); ++i)
        from.push_back(base::cast<float>(random.unitVector() * random.uniform(0.97, 1.03)));
    std::vector<Projection<float>> feet(from.size());
    project(surface, from, {}, feet);
    std::vector<Curvature> bent(from.size());
    std::vector<Vec3f> at;
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        QVERIFY(feet[i].ok());
        const Vec3d foot = base::cast<double>(feet[i].foot);
        const double error = length(foot) - 1;
        sum += error * error;
        QVERIFY2(std::abs(error) < 1e-3, qPrintable(QString::number(error)));
        QVERIFY(distance(base::normalized(base::cast<double>(feet[i].at.gradient)), base::normalized(foot)) < 0.03);
        QVERIFY(distance(base::normalized(foot), base::normalized(base::cast<double>(from[i]))) < 2e-3);
        at.push_back(feet[i].foot);
    }
    QVERIFY2(std::sqrt(sum / double(from.size())) < 1e-4,
             qPrintable(QString::number(std::sqrt(sum / double(from.size())))));
    curvature(shapes::surfaceOf(shapes::ellipsoids(shapes::sphere(4000, 1, 0.3), 2, test::seed())), at, bent);
    for (const Curvature& c : bent)
        QVERIFY(c.ok() && std::abs(c.mean() - 1) < 0.1);
}

void KnownEllipsoidsTest::raysMeetSpheres() {
    const surfel::SurfelList list = shapes::ellipsoids(shapes::sphere(4000, 1, 0.15), 3, test::seed());
    const Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed());
    for (const double beside : {0.0, 0.5, 0.9, 0.98, 1.02})
        for (int i = 0; i < test::effort(60); ++i) {
            const Vec3d towards = random.unitVector(), side = base::perpendicular(towards);
            const base::Rayf ray{base::cast<float>(side * beside - towards * 3), base::cast<float>(towards)};
            for (const bool robust : {false, true}) {
                IntersectOptions options;
                options.robust = robust;
                const RayHit<float> hit = intersect(surface, ray, options);
                QCOMPARE(hit.hit, beside < 1);
                QCOMPARE(intersectAny(surface, ray, options), beside < 1);
                if (hit.hit)
                    QVERIFY(std::abs(double(hit.t) - (3 - std::sqrt(1 - beside * beside))) <
                            (beside > 0.95 ? 1e-2 : 2e-3));
            }
        }
}

static const test::Registered<KnownEllipsoidsTest> registered;
#include "known_ellipsoids_test.moc"
