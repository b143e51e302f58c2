// Rays and the surface of cells: where there is no crease the bits are those of the surface itself, and batches give
// the bits of single rays.
#include "core/cells/cell_rays.h"

#include "cells/solids.h"
#include "support/registry.h"
#include "surface/ellipsoids.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using base::Rayd;
using cells::CellSurface;

class CellBitsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void modelsOfOneCellGiveTheSameBits();
    void awayFromCreasesBitsStay();
    void batchesKeepTheBitsAwayFromCreases();
    void batchesGiveTheBitsOfSingles();
    void ballsAsEllipsoidsGiveTheSameBits();
    void ellipsoidsOnPlanesMakeTheSameSolid();
};

void CellBitsTest::modelsOfOneCellGiveTheSameBits() {
    Random random(test::seed());
    SampledSolid s = sampled(intersection({{{0, 0, 1}, 0.3}}), 1, 0.06, random);
    const CellSurface surface = cellsOf(s.surfels);
    std::vector<base::Rayf> rays;
    for (int k = 0; k < 200; ++k) {
        const Rayd ray = towards(random.unitVector() * random.uniform(), random.unitVector(), 3);
        rays.push_back({base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> plain(rays.size()), byCells(rays.size());
    intersect(surface.surface(), rays, {}, plain);
    intersect(surface, rays, {}, byCells);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        QCOMPARE(byCells[i].hit, plain[i].hit);
        QVERIFY(byCells[i].t == plain[i].t && byCells[i].normal == plain[i].normal);
    }
}

void CellBitsTest::awayFromCreasesBitsStay() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.06, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(200); ++k) {
        const Vec3d target{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 1};
        const Rayd ray = towards(target, -base::normalized(random.unitVector() + Vec3d{0, 0, 2}), 1);
        const surface::RayHit<double> plain = intersectReference(surface.surface(), ray);
        const surface::RayHit<double> byCells = intersectReference(surface, ray);
        if (std::abs(plain.position.x) < 0.2 && std::abs(plain.position.y) < 0.2 && std::abs(ray.direction.z) > 0.8) {
            QCOMPARE(byCells.hit, plain.hit);
            QVERIFY(byCells.t == plain.t && byCells.position == plain.position);
        }
    }
}

/// More rays than are sorted together, from all sides, of which most come nowhere near a seam.
void CellBitsTest::batchesKeepTheBitsAwayFromCreases() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.06, random);
    const CellSurface surface = cellsOf(s.surfels);
    std::vector<base::Rayf> rays;
    for (int k = 0; k < test::effort(800); ++k) {
        const Rayd ray = towards(random.unitVector() * random.uniform(), random.unitVector(), 4);
        rays.push_back({base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> plain(rays.size()), byCells(rays.size());
    intersect(surface.surface(), rays, {}, plain);
    intersect(surface, rays, {}, byCells);
    int away = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        std::array<float, 3> far; // of the hit from the three pairs of faces
        for (std::size_t a = 0; a < 3; ++a)
            far[a] = std::abs(1 - std::abs(plain[i].position[a]));
        std::sort(far.begin(), far.end());
        if (!plain[i].hit || far[1] < 0.21f) // h is 3.5 spacings
            continue;
        ++away;
        QVERIFY2(byCells[i].t == plain[i].t && byCells[i].outward == plain[i].outward,
                 qPrintable(QString("seed %1, ray %2").arg(test::seed()).arg(i)));
    }
    QVERIFY(away > test::effort(800) / 4);
}

void CellBitsTest::batchesGiveTheBitsOfSingles() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.1, random);
    const CellSurface surface = cellsOf(s.surfels);
    std::vector<base::Rayf> rays;
    for (int k = 0; k < 100; ++k) {
        const Rayd ray = towards(random.unitVector() * 1.2 * random.uniform(), random.unitVector(), 4);
        rays.push_back({base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> all(rays.size()), one(1);
    std::vector<std::uint8_t> any(rays.size());
    std::vector<std::vector<surface::RayHit<float>>> every(rays.size());
    intersect(surface, rays, {}, all);
    intersectAny(surface, rays, {}, any);
    intersectAll(surface, rays, {}, every);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        intersect(surface, {&rays[i], 1}, {}, one);
        QVERIFY(one[0].hit == all[i].hit && one[0].t == all[i].t && one[0].normal == all[i].normal);
        QCOMPARE(any[i] != 0, all[i].hit);
        QCOMPARE(every[i].empty(), !all[i].hit);
        if (all[i].hit)
            QVERIFY(std::abs(every[i].front().t - all[i].t) < 1e-5f);
    }
}

void CellBitsTest::ballsAsEllipsoidsGiveTheSameBits() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.1, random);
    const CellSurface plain = cellsOf(s.surfels), shaped = cellsOf(shapes::balls(s.surfels));
    for (int k = 0; k < test::effort(100); ++k) {
        const Rayd ray = towards(random.unitVector() * 1.2 * random.uniform(), random.unitVector(), 4);
        const surface::RayHit<double> a = intersectReference(plain, ray), b = intersectReference(shaped, ray);
        QCOMPARE(a.hit, b.hit);
        QVERIFY(a.t == b.t && a.normal == b.normal);
    }
}

/// Every sum over samples of a plane with its normal is that plane, whatever the supports.
void CellBitsTest::ellipsoidsOnPlanesMakeTheSameSolid() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.06, random);
    const CellSurface surface = cellsOf(shapes::ellipsoids(s.surfels, 2, test::seed()));
    int hits = 0;
    for (int k = 0; k < test::effort(100); ++k) {
        const Rayd ray = towards(random.unitVector() * 0.8 * random.uniform(), random.unitVector(), 4);
        std::size_t plane = 0;
        const double expected = s.solid.hit(ray, plane);
        const surface::RayHit<double> hit = intersectReference(surface, ray);
        if (!hit.hit || expected < 0)
            continue;
        ++hits;
        QVERIFY2(std::abs(hit.t - expected) < 1e-5, qPrintable(QString("%1, not %2").arg(hit.t).arg(expected)));
    }
    QVERIFY(hits > test::effort(100) / 2);
}

static const test::Registered<CellBitsTest> registered;
#include "cell_bits_test.moc"
