// Rays and the surface of cells: solids of planes keep their edges and corners, and no ray is lost.
#include "core/cells/cell_rays.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using base::Rayd;
using cells::CellSurface;

class CellRaysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void boxesAreHitWhereTheyAre_data();
    void boxesAreHitWhereTheyAre();
    void pyramidsKeepTheirTips();
    void anyCornerOfPlanesIsHitWhereItIs_data();
    void anyCornerOfPlanesIsHitWhereItIs();
    void thinPlatesLoseNoRay();
    void allHitsAlternate();
    void anyHitAgreesWithTheFirst();
    void raysInAFaceMiss();
    void theFirstHitIsTheFirstOfAll();
    void hitsDoNotDependOnHowFarAwayRaysBegin();
};

namespace {

/// A point of the solid's surface that is within `near` of an edge, or anywhere, by the surfels and their partners.
Vec3d targetOn(const SampledSolid& s, Random& random, bool atEdge) {
    const cells::LabelLayout labels = *cells::LabelLayout::of(*s.surfels.layout);
    for (;;) {
        const std::size_t i = random.below(s.surfels.size());
        if (!atEdge || labels.at(s.surfels.extraOf(i)).meeting != cells::Meeting::None)
            return base::cast<double>(s.surfels.items[i].position) +
                   random.unitVector() * (0.5 * s.spacing * random.uniform());
    }
}

struct Errors {
    int rays = 0, lost = 0, wrong = 0, grazing = 0;
    double worst = 0;
    QString first; ///< what the cells say where the first one is lost or wrong
};

/// Cell: surfels, f in spacings (true one), off-centre value in h; how it meets those before.
QString describe(const SampledSolid& s, const CellSurface& surface, const Vec3d& x) {
    cells::CellSource source(surface);
    source.moveTo(x);
    QString out;
    for (std::size_t i = 0; i < source.count(); ++i) {
        const surface::Evaluationd& at = source.at(i, surface::Need::Gradient);
        out += QString(" %1: %2, %3 (%4), o %5;")
                   .arg(source.cell(i))
                   .arg(source.samples(i))
                   .arg(at.value / s.spacing)
                   .arg(s.solid.planes[source.cell(i)].f(x) / s.spacing)
                   .arg(at.offCentre / at.unit);
        for (std::size_t j = 0; j < source.count(); ++j)
            if (j != i)
                out += QString(" %1%2").arg(source.cell(j)).arg("0+-"[static_cast<int>(source.meeting(i, j))]);
    }
    return out;
}

/// Rays at the solid from outside; those that pass less than 0.05 spacings of solid or air beside it are left out, as
/// they are beyond what any tolerance means.
Errors shoot(const SampledSolid& s, const CellSurface& surface, Random& random, int count, double within) {
    Errors out;
    for (int k = 0; k < count; ++k) {
        const Vec3d target = targetOn(s, random, k % 3 != 0);
        if (length(target) > within)
            continue;
        const Rayd ray = towards(target, random.unitVector(), 2.5 * within);
        if (s.solid.value(ray.origin) <= 0)
            continue;
        std::size_t plane = 0;
        const double t = s.solid.hit(ray, plane);
        if (t >= 0 && length(ray.at(t)) > within)
            continue; // beyond what is sampled
        // what the same ray hits when it is moved a little
        bool same = true;
        for (int m = 0; m < 4; ++m) {
            const Vec3d aside = base::normalized(cross(ray.direction, random.unitVector())) * (0.02 * s.spacing);
            std::size_t other = 0;
            const double t2 = s.solid.hit({ray.origin + aside, ray.direction}, other);
            same &= (t2 >= 0) == (t >= 0) && (t < 0 || std::abs(t2 - t) < s.spacing);
        }
        if (!same || (t >= 0 && std::abs(dot(s.solid.planes[plane].n, ray.direction)) < 0.02)) {
            ++out.grazing;
            continue;
        }
        const cells::CellHit hit = intersectCells(surface, ray);
        ++out.rays;
        const bool inside = hit.hit.hit && length(hit.hit.position) > within;
        if (t < 0 ? hit.hit.hit && !inside : !hit.hit.hit) {
            ++out.lost;
            if (out.first.isEmpty())
                out.first = describe(s, surface, t < 0 ? hit.hit.position : ray.at(t));
            continue;
        }
        if (t < 0)
            continue;
        const double off = std::abs(s.solid.planes[plane].f(hit.hit.position)) / s.spacing;
        out.worst = std::max(out.worst, std::abs(hit.hit.t - t) / s.spacing *
                                            std::abs(dot(s.solid.planes[plane].n, ray.direction)));
        out.wrong += off > 1e-3 ? 1 : 0;
        if (off > 1e-3 && out.first.isEmpty())
            out.first = describe(s, surface, ray.at(t)) + ", hit" + describe(s, surface, hit.hit.position);
    }
    return out;
}

QByteArray told(const Errors& e) {
    return QByteArray("rays ") + QByteArray::number(e.rays) + ", lost " + QByteArray::number(e.lost) + ", wrong " +
           QByteArray::number(e.wrong) + ", grazing " + QByteArray::number(e.grazing) + ", worst " +
           QByteArray::number(e.worst) + " s" + e.first.toUtf8();
}

} // namespace

void CellRaysTest::boxesAreHitWhereTheyAre_data() {
    QTest::addColumn<bool>("block");
    QTest::addColumn<double>("spacing");
    for (const double spacing : {0.1, 0.063}) {
        QTest::addRow("cube %g", spacing) << false << spacing;
        QTest::addRow("L-block %g", spacing) << true << spacing;
    }
}

/// Faces that lie on numbers which float32 holds: nothing but the arithmetic of double is left.
void CellRaysTest::boxesAreHitWhereTheyAre() {
    QFETCH(bool, block);
    QFETCH(double, spacing);
    Random random(test::seed());
    const SampledSolid s = sampled(block ? lBlock(1) : cube(1), 2, spacing, random);
    const CellSurface surface = cellsOf(s.surfels);
    const Errors e = shoot(s, surface, random, test::effort(600), 1.9);
    qInfo() << told(e).constData();
    QVERIFY2(e.rays > 50, told(e));
    QVERIFY2(e.lost == 0, told(e));
    QVERIFY2(e.worst < 1e-9, told(e));
}

void CellRaysTest::pyramidsKeepTheirTips() {
    Random random(test::seed());
    for (const int sides : {3, 4, 8}) {
        const SampledSolid s = sampled(pyramid(sides, 0.8, 0.9), 1.7, 0.06, random);
        const CellSurface surface = cellsOf(s.surfels);
        const Errors e = shoot(s, surface, random, test::effort(600), 1.6);
        qInfo() << sides << told(e).constData();
        QVERIFY2(e.lost == 0, told(e));
        QVERIFY2(e.worst < 1e-4, told(e));
    }
}

void CellRaysTest::anyCornerOfPlanesIsHitWhereItIs_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("two planes") << 0;
    QTest::newRow("three planes cut") << 1;
    QTest::newRow("three planes joined") << 2;
    QTest::newRow("mixed, cut") << 3;
    QTest::newRow("mixed, joined") << 4;
    QTest::newRow("four planes") << 5;
}

/// Dihedral angles from 20 to 160 degrees, any place, scale and rotation.
void CellRaysTest::anyCornerOfPlanesIsHitWhereItIs() {
    QFETCH(int, kind);
    Random random(test::seed() + static_cast<unsigned long long>(kind));
    Errors sum;
    int solids = 0;
    for (int k = 0; k < test::effort(24); ++k) {
        const std::size_t count = kind == 0 ? 2 : kind == 5 ? 4 : 3;
        std::vector<Plane> planes;
        const Vec3d up = random.unitVector();
        for (int tries = 0; planes.size() < count && tries < 1000; ++tries) {
            Vec3d n = random.unitVector();
            if (kind == 5) { // around an axis: a tip of four faces, none of which is idle
                const Vec3d u = base::perpendicular(up), v = cross(up, u);
                const double a = (static_cast<double>(planes.size()) + random.uniform(-0.2, 0.2)) * pi / 2;
                n = base::normalized((u * std::cos(a) + v * std::sin(a)) + up * random.uniform(0.3, 1));
            }
            bool good = true;
            for (const Plane& other : planes)
                good &= std::abs(dot(other.n, n)) < std::cos(20 * pi / 180);
            if (planes.size() == 2 && kind != 5)
                good &= std::abs(dot(cross(planes[0].n, planes[1].n), n)) > 0.25;
            if (good)
                planes.push_back({n, 0});
        }
        if (planes.size() < count)
            continue;
        const Solid solid = kind == 2                 ? unionOf(planes)
                            : kind == 3               ? mixedCorner(planes, true)
                            : kind == 4               ? mixedCorner(planes, false)
                            : kind == 0 && k % 2 == 1 ? unionOf(planes)
                                                      : intersection(planes);
        const SampledSolid s = sampled(solid, 1, 0.05, random);
        if (s.surfels.size() < 200)
            continue; // next to nothing of the ball
        const CellSurface surface = cellsOf(s.surfels);
        const Errors e = shoot(s, surface, random, 150, 0.75);
        if (e.lost + e.wrong > 0)
            qInfo() << "solid" << k << told(e).constData();
        sum.rays += e.rays, sum.lost += e.lost, sum.wrong += e.wrong, sum.grazing += e.grazing;
        sum.worst = std::max(sum.worst, e.worst);
        ++solids;
    }
    qInfo() << solids << "solids," << told(sum).constData();
    QVERIFY2(sum.rays > 20, told(sum));
    const bool saddle = kind == 3 || kind == 4; // cells/README 11
    QVERIFY2(1000 * (sum.lost + sum.wrong) <= (saddle ? 12 : 2) * sum.rays,
             (told(sum) + ", seed " + QByteArray::number(test::seed())));
}

/// Walls whose both sides are in each other's support, and which no surfel has as partners.
void CellRaysTest::thinPlatesLoseNoRay() {
    Random random(test::seed());
    for (const double thickness : {1.0, 1.9, 2.5}) {
        constexpr double spacing = 0.06;
        Solid plate = cube(1);
        plate.planes[4].d = plate.planes[5].d = thickness * spacing / 2;
        const SampledSolid s = sampled(plate, 1.6, spacing, random);
        const CellSurface surface = cellsOf(s.surfels);
        int lost = 0, rays = 0;
        double worst = 0;
        for (int k = 0; k < test::effort(300); ++k) {
            const Vec3d target{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), plate.planes[4].d};
            const Rayd ray = towards(target, -base::normalized(random.unitVector() + Vec3d{0, 0, 1.2}), 3);
            if (ray.direction.z > -0.1)
                continue;
            const cells::CellHit hit = intersectCells(surface, ray);
            ++rays;
            lost += hit.hit.hit ? 0 : 1;
            if (hit.hit.hit)
                worst = std::max(worst, std::abs(hit.hit.position.z - target.z) / spacing);
        }
        QVERIFY(rays > 20);
        QCOMPARE(lost, 0);
        QVERIFY2(worst < 1e-6, QByteArray::number(worst));
    }
}

void CellRaysTest::allHitsAlternate() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.08, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(100); ++k) {
        const Vec3d target{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.5, 0.5)};
        const Rayd ray = towards(target, random.unitVector(), 4);
        const std::vector<cells::CellHit> hits = intersectAllCells(surface, ray);
        // entries and exits in turn, half-way between two of them the solid or the air
        QVERIFY2(hits.size() % 2 == 0, QByteArray::number(k));
        for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
            if (hits[i + 1].hit.t - hits[i].hit.t < 1e-6)
                continue;
            const double middle = s.solid.value(ray.at((hits[i].hit.t + hits[i + 1].hit.t) / 2));
            QVERIFY2((middle < 0) == (i % 2 == 0), QByteArray::number(k));
        }
    }
}

void CellRaysTest::anyHitAgreesWithTheFirst() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 2, 0.1, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(200); ++k) {
        const Vec3d target{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), random.uniform(-1, 1)};
        const Rayd ray = towards(target, random.unitVector(), 4);
        QCOMPARE(intersectAnyReference(surface, ray), intersectReference(surface, ray).hit);
    }
}

void CellRaysTest::raysInAFaceMiss() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.1, random);
    const CellSurface surface = cellsOf(s.surfels);
    QVERIFY(!intersectCells(surface, {{-3, 0.2, 1.02}, {1, 0, 0}}).hit.hit);
    QVERIFY(!intersectCells(surface, {{-3, 1.001, 1.001}, {1, 0, 0}}).hit.hit);
    QVERIFY(intersectCells(surface, {{-3, 0.999, 0.999}, {1, 0, 0}}).hit.hit);
}

/// The first hit is looked for piece by piece, all hits at once.
void CellRaysTest::theFirstHitIsTheFirstOfAll() {
    Random random(test::seed());
    int hits = 0;
    for (int k = 0; k < test::effort(12); ++k) {
        const SampledSolid s = sampled(k % 2 == 0 ? polyhedron(random) : lBlock(1), 1.6, 0.12, random);
        const CellSurface surface = cellsOf(s.surfels);
        for (int m = 0; m < 40; ++m) {
            const Rayd ray = towards(targetOn(s, random, m % 2 == 0), random.unitVector(), 4);
            const cells::CellHit first = intersectCells(surface, ray);
            const std::vector<cells::CellHit> all = intersectAllCells(surface, ray);
            QVERIFY2(first.hit.hit == !all.empty(), qPrintable(QString("seed %1").arg(test::seed())));
            if (all.empty())
                continue;
            ++hits;
            QVERIFY2(std::abs(first.hit.t - all.front().hit.t) < 1e-3 * s.spacing,
                     qPrintable(QString("seed %1: %2 %3").arg(test::seed()).arg(first.hit.t).arg(all.front().hit.t)));
        }
    }
    QVERIFY(hits > test::effort(12) * 20);
}

void CellRaysTest::hitsDoNotDependOnHowFarAwayRaysBegin() {
    Random random(test::seed());
    const SampledSolid s = sampled(lBlock(1), 1.6, 0.1, random);
    const CellSurface surface = cellsOf(s.surfels);
    for (int k = 0; k < test::effort(100); ++k) {
        const Rayd near = towards(targetOn(s, random, true), random.unitVector(), 4);
        const Rayd far{near.origin - near.direction * 1e4, near.direction};
        const cells::CellHit a = intersectCells(surface, near), b = intersectCells(surface, far);
        QVERIFY2(a.hit.hit == b.hit.hit, qPrintable(QString("seed %1").arg(test::seed())));
        if (a.hit.hit)
            QVERIFY(std::abs(a.hit.t + 1e4 - b.hit.t) < 1e-6);
    }
}

static const test::Registered<CellRaysTest> registered;
#include "cell_rays_test.moc"
