// All hits along rays and any hit of them, on surfaces whose roots are known; batches and thread counts.
#include "core/base/parallel.h"
#include "support/registry.h"
#include "support/thread_counts.h"
#include "surface/rays/dense_march.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3d, base::Vec3f;

class RayKindsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sphereHitsLieWhereTheyShould_data();
    void sphereHitsLieWhereTheyShould();
    void allHitsOfATorusAreFound_data();
    void allHitsOfATorusAreFound();
    void reversedRaysHitTheSameSet_data();
    void reversedRaysHitTheSameSet();
    void allHitsRespectTheRange();
    void anyAgreesWithFirst_data();
    void anyAgreesWithFirst();
    void shadowRaysDoNotMeetTheirStart_data();
    void shadowRaysDoNotMeetTheirStart();
    void raysThroughHolesMiss();
    void moebiusStripsAreHitFromBothSides();
    void curvesAreNotHit();
    void batchesGiveTheBitsOfSinglesAtAnyThreadCount_data();
    void batchesGiveTheBitsOfSinglesAtAnyThreadCount();
};

namespace {

base::Rayd towards(const Vec3d& target, const Vec3d& direction, double from) {
    return {target - direction * from, direction};
}
base::Rayf cast(const base::Rayd& ray) {
    return {base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))};
}

void policies() {
    QTest::addColumn<bool>("robust");
    QTest::addRow("fast") << false;
    QTest::addRow("robust") << true;
}
IntersectOptions policy(bool robust) {
    IntersectOptions out;
    out.robust = robust;
    return out;
}

QString where(int ray) {
    return QString("ray %1, seed %2").arg(ray).arg(test::seed());
}

/// Where a ray meets the torus about the z axis, by signs in short steps and bisection.
std::vector<double> torusRoots(const base::Rayd& ray, double major, double minor) {
    const auto f = [&](double t) {
        const Vec3d x = ray.at(t);
        return std::hypot(std::hypot(x.x, x.y) - major, x.z) - minor;
    };
    std::vector<double> out;
    constexpr double step = 1e-3;
    for (double t = 0; t < 8; t += step)
        if ((f(t) < 0) != (f(t + step) < 0)) {
            double a = t, b = t + step;
            for (int i = 0; i < 50; ++i)
                ((f(0.5 * (a + b)) < 0) == (f(a) < 0) ? a : b) = 0.5 * (a + b);
            out.push_back(a);
        }
    return out;
}

/// No root so close to another, and none so flat, that ripples of the sampling decide.
bool isClear(const base::Rayd& ray, const std::vector<double>& roots, double major) {
    for (std::size_t i = 0; i < roots.size(); ++i) {
        const Vec3d x = ray.at(roots[i]);
        const Vec3d ring = base::normalized(Vec3d{x.x, x.y, 0}) * major;
        if (std::abs(dot(base::normalized(x - ring), ray.direction)) < 0.1)
            return false;
    }
    return true;
}

} // namespace

void RayKindsTest::sphereHitsLieWhereTheyShould_data() {
    policies();
}

/// t = distance - sqrt(rho^2 - b^2) with the radius of surface/README 1.2 for mu = 0.
void RayKindsTest::sphereHitsLieWhereTheyShould() {
    QFETCH(bool, robust);
    const double h = 0.3, rho = (35 + std::sqrt(1296 - 355 * h * h)) / 71;
    const Surface surface = shapes::surfaceOf(shapes::sphere(20000, 1, h), shapes::definitionOf(Frame::Normals, false));
    base::Random random(test::seed());
    for (int i = 0; i < 60; ++i) {
        const double b = rho * random.uniform(0, 0.98);
        const Vec3d d = random.unitVector(), side = base::normalized(cross(d, random.unitVector()));
        const base::Rayd ray = towards(side * b, d, 4);
        const double half = std::sqrt(rho * rho - b * b);
        const auto all = intersectAllReference(surface, ray, policy(robust));
        QVERIFY2(all.size() == 2, qPrintable(where(i)));
        const double steep = half / rho;
        QVERIFY2(std::abs(all[0].t - (4 - half)) < 2e-6 / steep && std::abs(all[1].t - (4 + half)) < 2e-6 / steep,
                 qPrintable(where(i) + QString(": %1 %2").arg(all[0].t - 4 + half).arg(all[1].t - 4 - half)));
        const RayHit<float> first = intersect(surface, cast(ray), policy(robust));
        QVERIFY(first.hit && std::abs(double(first.t) - all[0].t) < 3e-6 / steep);
    }
}

void RayKindsTest::allHitsOfATorusAreFound_data() {
    policies();
}

void RayKindsTest::allHitsOfATorusAreFound() {
    QFETCH(bool, robust);
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, 0.05, 0.175));
    base::Random random(test::seed());
    int fours = 0, compared = 0;
    const int tries = test::effort(250);
    for (int i = 0; i < tries; ++i) {
        Vec3d d = random.unitVector();
        d.z *= i % 2 == 0 ? 0.2 : 1; // half of them along the ring
        const base::Rayd ray = towards(random.unitVector() * random.uniform(0, 0.6), base::normalized(d), 3);
        const std::vector<double> roots = torusRoots(ray, 1, 0.4);
        if (!isClear(ray, roots, 1))
            continue;
        ++compared;
        fours += roots.size() == 4;
        const auto hits = intersectAll(surface, cast(ray), policy(robust));
        QVERIFY2(hits.size() == roots.size(),
                 qPrintable(where(i) + QString(": %1 of %2").arg(hits.size()).arg(roots.size())));
        for (std::size_t k = 0; k < hits.size(); ++k) {
            QVERIFY2(std::abs(double(hits[k].t) - roots[k]) < 0.01, qPrintable(where(i)));
            const bool entering = k % 2 == 0;
            QVERIFY2((dot(hits[k].outward, base::cast<float>(ray.direction)) < 0) == entering, qPrintable(where(i)));
        }
    }
    QVERIFY(20 * compared > 9 * tries && fours > tries / 15);
}

void RayKindsTest::reversedRaysHitTheSameSet_data() {
    policies();
}

void RayKindsTest::reversedRaysHitTheSameSet() {
    QFETCH(bool, robust);
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, test::seed()));
    base::Random random(test::seed());
    int hits = 0, differ = 0;
    for (int i = 0; i < 120; ++i) {
        const base::Rayd ray = towards(random.unitVector() * random.uniform(0, 1.2), random.unitVector(), 3);
        const auto there = intersectAllReference(surface, ray, policy(robust));
        const auto back = intersectAllReference(surface, {ray.at(6), -ray.direction}, policy(robust));
        bool same = there.size() == back.size();
        for (std::size_t k = 0; same && k < there.size(); ++k)
            same = distance(there[k].position, back[back.size() - 1 - k].position) < 1e-8;
        hits += static_cast<int>(there.size());
        differ += !same;
    }
    // where a ray grazes a wave of the noise, steps from the other side may fall on either side of it
    QVERIFY2(hits > 100 && differ <= 1, qPrintable(QString("%1 of 120 differ, seed %2").arg(differ).arg(test::seed())));
}

void RayKindsTest::allHitsRespectTheRange() {
    const Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, 0.05, 0.175));
    const base::Rayf ray{{-4, 0.1f, 0.05f}, {1, 0, 0}};
    for (const bool robust : {false, true}) {
        IntersectOptions options = policy(robust);
        const auto all = intersectAll(surface, ray, options);
        QCOMPARE(all.size(), std::size_t(4));
        options.tMin = 0.5f * (all[0].t + all[1].t);
        options.tMax = 0.5f * (all[2].t + all[3].t);
        const auto some = intersectAll(surface, ray, options);
        QCOMPARE(some.size(), std::size_t(2));
        QVERIFY(std::abs(some[0].t - all[1].t) < 1e-5f && std::abs(some[1].t - all[2].t) < 1e-5f);
    }
}

void RayKindsTest::anyAgreesWithFirst_data() {
    policies();
}

void RayKindsTest::anyAgreesWithFirst() {
    QFETCH(bool, robust);
    const Surface surface = shapes::surfaceOf(shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, test::seed()));
    base::Random random(test::seed());
    int hits = 0, differ = 0;
    const int tries = test::effort(500);
    for (int i = 0; i < tries; ++i) {
        const base::Rayd ray = towards(random.unitVector() * random.uniform(0, 1.4), random.unitVector(), 4);
        const RayHit<float> first = intersect(surface, cast(ray), policy(robust));
        hits += first.hit;
        differ += intersectAny(surface, cast(ray), policy(robust)) != first.hit;
        if (i % 5 == 0)
            differ += intersectAnyReference(surface, ray, policy(robust)) != first.hit;
        if (first.hit) { // nothing before the hit
            IntersectOptions before = policy(robust);
            before.tMax = first.t - 0.05f;
            QVERIFY2(!intersectAny(surface, cast(ray), before), qPrintable(where(i)));
        }
    }
    QVERIFY2(10 * hits > 3 * tries && 10 * hits < 9 * tries && differ <= 2,
             qPrintable(QString("%1, seed %2").arg(differ).arg(test::seed())));
}

void RayKindsTest::shadowRaysDoNotMeetTheirStart_data() {
    policies();
}

/// From hits on the surface: away from it nothing, into it the other side, at flat angles too.
void RayKindsTest::shadowRaysDoNotMeetTheirStart() {
    QFETCH(bool, robust);
    for (const bool oriented : {true, false}) {
        surfel::SurfelList list = shapes::sphere(5000, 1, 0.18);
        list.layout = shapes::layout(true, oriented);
        const Surface surface = shapes::surfaceOf(list);
        base::Random random(test::seed());
        for (int i = 0; i < test::effort(200); ++i) {
            const RayHit<float> start =
                intersect(surface, cast(towards({0, 0, 0}, random.unitVector(), 3)), policy(robust));
            QVERIFY2(start.hit, qPrintable(where(i)));
            const Vec3d n = base::cast<double>(start.normal);
            const Vec3d tangent = base::normalized(cross(n, random.unitVector()));
            const double rise = i % 2 == 0 ? random.uniform(0.1, 1) : random.uniform(0.01, 0.1);
            const Vec3f d = base::normalized(base::cast<float>(tangent + n * rise));
            QVERIFY2(!intersectAny(surface, {start.position, d}, policy(robust)), qPrintable(where(i)));
            const Vec3f in = base::normalized(base::cast<float>(tangent - n * std::max(rise, 0.1)));
            QVERIFY2(intersectAny(surface, {start.position, in}, policy(robust)), qPrintable(where(i)));
        }
    }
}

void RayKindsTest::raysThroughHolesMiss() {
    const double s = 0.05, h = 0.175, hole = 0.4;
    surfel::SurfelList list = shapes::plane(30, s, h);
    std::erase_if(list.items, [&](const surfel::Surfel& each) { return length(each.position) < float(hole); });
    SurfaceDefinition definition;
    definition.boundary = Boundary::Limit;
    definition.boundaryLimit = 0.3f;
    const Surface open = shapes::surfaceOf(list, definition);
    const Surface behind = [&] {
        surfel::SurfelList two = list;
        for (const surfel::Surfel& each : shapes::plane(30, s, h, -1).items)
            two.items.push_back(each);
        return shapes::surfaceOf(two, definition);
    }();
    base::Random random(test::seed());
    for (const bool robust : {false, true})
        for (int i = 0; i < test::effort(150); ++i) {
            const double a = random.uniform(0, 2 * shapes::pi);
            // the boundary lies 0.13 h beyond the edge of the samples (surface/README 5.1), which is 0.5 s wide here
            const double r = i % 2 == 0 ? random.uniform(0, hole - 0.2 * h - 0.5 * s) : random.uniform(hole + s, 1);
            const Vec3d target{r * std::cos(a), r * std::sin(a), 0};
            const Vec3d d = base::normalized(Vec3d{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -1});
            const base::Rayf ray = cast(towards(target, d, 2));
            QVERIFY2(intersect(open, ray, policy(robust)).hit == (r > hole), qPrintable(where(i)));
            QVERIFY2(intersectAny(open, ray, policy(robust)) == (r > hole), qPrintable(where(i)));
            const RayHit<float> hit = intersect(behind, ray, policy(robust));
            if (std::abs(target.x + d.x / 1) < 1.3 && std::abs(target.y + d.y / 1) < 1.3)
                QVERIFY2(hit.hit && std::abs(double(hit.position.z) - (r > hole ? 0 : -1)) < 1e-4,
                         qPrintable(where(i)));
        }
}

void RayKindsTest::moebiusStripsAreHitFromBothSides() {
    surfel::SurfelList list;
    list.layout = shapes::layout(true, false);
    base::Random random(test::seed());
    for (int i = 0; i < 240; ++i)
        for (int j = -9; j <= 9; ++j) {
            const double a = 2 * shapes::pi * i / 240, r = 0.027 * j;
            const Vec3d ring{std::cos(a), std::sin(a), 0},
                across = ring * std::cos(a / 2) + Vec3d{0, 0, std::sin(a / 2)};
            const Vec3d n = base::normalized(cross(Vec3d{-std::sin(a), std::cos(a), 0}, across));
            list.items.push_back(shapes::surfelAt(ring + across * r, random.below(2) == 0 ? n : -n, 0.095));
        }
    SurfaceDefinition definition;
    definition.boundaryLimit = 0.3f;
    const Surface surface = shapes::surfaceOf(list, definition);
    int hits = 0;
    for (int i = 0; i < 150; ++i) {
        const base::Rayd ray = towards(random.unitVector() * random.uniform(0.5, 1.1), random.unitVector(), 3);
        const auto there = intersectAll(surface, cast(ray));
        const auto back = intersectAll(surface, cast({ray.at(6), -ray.direction}));
        const bool grazes = std::any_of(there.begin(), there.end(), [&](const RayHit<float>& hit) {
            return std::abs(dot(hit.normal, base::cast<float>(ray.direction))) < 0.2f;
        });
        if (grazes)
            continue;
        hits += static_cast<int>(there.size());
        QVERIFY2(there.size() == back.size(), qPrintable(where(i)));
        for (std::size_t k = 0; k < there.size(); ++k)
            QVERIFY2(distance(there[k].position, back[back.size() - 1 - k].position) < 1e-4f, qPrintable(where(i)));
    }
    QVERIFY(hits > 30);
}

void RayKindsTest::curvesAreNotHit() {
    surfel::SurfelList list;
    list.layout = shapes::layout(true, true);
    for (int i = 0; i < 200; ++i)
        list.items.push_back(shapes::surfelAt({0.01 * i, 0, 0}, {1, 0, 0}, 0.05));
    SurfaceDefinition definition;
    definition.manifold = Manifold::Curve;
    const Surface curve = shapes::surfaceOf(list, definition);
    for (const bool robust : {false, true})
        QVERIFY(!intersect(curve, {{1, 0, 1}, {0, 0, -1}}, policy(robust)).hit);
}

void RayKindsTest::batchesGiveTheBitsOfSinglesAtAnyThreadCount_data() {
    QTest::addColumn<bool>("robust");
    QTest::addColumn<bool>("oriented");
    QTest::addColumn<bool>("scattered");
    for (const bool robust : {false, true})
        for (const bool oriented : {false, true})
            for (const bool scattered : {false, true})
                QTest::addRow("robust=%d oriented=%d scattered=%d", robust, oriented, scattered)
                    << robust << oriented << scattered;
}

void RayKindsTest::batchesGiveTheBitsOfSinglesAtAnyThreadCount() {
    QFETCH(bool, robust);
    QFETCH(bool, oriented);
    QFETCH(bool, scattered);
    surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.18), 0.008, 5);
    list.layout = shapes::layout(true, oriented);
    const Surface surface = shapes::surfaceOf(list);
    base::Random random(test::seed());
    std::vector<base::Rayf> rays;
    for (int i = 0; i < 700; ++i) {
        const Vec3d camera{(i % 35) / 17.5 - 1, (i / 35) / 10.0 - 1, 0};
        const Vec3d d = scattered ? random.unitVector() : base::normalized(camera - Vec3d{0, 0.1, 4});
        // some start near the surface, or inside
        const double from = i % 7 == 0 ? 0.3 : 4;
        rays.push_back(cast(towards(scattered ? random.unitVector() * random.uniform(0, 1.4) : camera, d, from)));
    }
    rays[33].direction = {0, 0, 0};
    std::vector<RayHit<float>> first(rays.size());
    std::vector<std::vector<RayHit<float>>> all(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    const auto same = [](const RayHit<float>& a, const RayHit<float>& b) {
        return a.hit == b.hit && a.t == b.t && a.normal == b.normal && a.position == b.position &&
               a.agreement == b.agreement && a.evaluations == b.evaluations;
    };
    std::vector<RayHit<float>> firstAlone;
    std::vector<std::vector<RayHit<float>>> allAlone;
    std::vector<bool> anyAlone;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        firstAlone.push_back(intersect(surface, rays[i], policy(robust)));
        anyAlone.push_back(intersectAny(surface, rays[i], policy(robust)));
        if (i % 4 == 0)
            allAlone.push_back(intersectAll(surface, rays[i], policy(robust)));
    }
    for (const int threads : test::comparedThreads({2, 3})) {
        base::setThreadCount(threads);
        intersect(surface, rays, policy(robust), first);
        intersectAll(surface, rays, policy(robust), all);
        intersectAny(surface, rays, policy(robust), any);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            QVERIFY2(same(first[i], firstAlone[i]), qPrintable(where(int(i))));
            QVERIFY2((any[i] != 0) == anyAlone[i], qPrintable(where(int(i))));
            if (i % 4 != 0)
                continue;
            const auto& single = allAlone[i / 4];
            QVERIFY2(single.size() == all[i].size() &&
                         std::equal(single.begin(), single.end(), all[i].begin(), all[i].end(), same),
                     qPrintable(where(int(i))));
        }
    }
    base::setThreadCount(0);
}

static const test::Registered<RayKindsTest> registered;
#include "ray_kinds_test.moc"
