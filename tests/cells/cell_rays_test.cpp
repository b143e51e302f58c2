// Rays and the surface of cells: solids of planes keep their edges and corners, and no ray is lost.
#include "core/cells/cell_rays.h"

#include "cells/solids.h"
#include "core/cells/cell_projection.h"
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
    void octantsKeepTheirSeams();
    void raysInAFaceMiss();
    void openEdgesAreWhole_data();
    void openEdgesAreWhole();
    void smallFlatCellsTearNoHoles();
    void cellsEndAtFinerOnes_data();
    void cellsEndAtFinerOnes();
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

/// An eighth of a ball: three quarters of discs and a part of a sphere.
void CellRaysTest::octantsKeepTheirSeams() {
    Random random(test::seed());
    constexpr double spacing = 0.04;
    const surfel::SurfelList surfels = octant(spacing, random);
    const CellSurface surface = cellsOf(surfels);
    const auto value = [](const Vec3d& x) { return std::max({-x.x, -x.y, -x.z, length(x) - 1}); };
    int lost = 0, rays = 0;
    double worst = 0;
    for (int k = 0; k < test::effort(400); ++k) {
        const std::size_t i = random.below(surfels.size());
        const Vec3d target = base::cast<double>(surfels.items[i].position) * 0.97 + Vec3d{0.01, 0.01, 0.01};
        const Rayd ray = towards(target, random.unitVector(), 3);
        if (value(target) > -0.2 * spacing)
            continue;
        ++rays;
        const cells::CellHit hit = intersectCells(surface, ray);
        if (!hit.hit.hit)
            ++lost;
        else
            worst = std::max(worst, std::abs(value(hit.hit.position)) / spacing);
    }
    qInfo() << rays << "rays, lost" << lost << "worst" << worst;
    QVERIFY(rays > 40);
    QCOMPARE(lost, 0);
    QVERIFY2(worst < 0.06, QByteArray::number(worst));
}

void CellRaysTest::raysInAFaceMiss() {
    Random random(test::seed());
    const SampledSolid s = sampled(cube(1), 2, 0.1, random);
    const CellSurface surface = cellsOf(s.surfels);
    QVERIFY(!intersectCells(surface, {{-3, 0.2, 1.02}, {1, 0, 0}}).hit.hit);
    QVERIFY(!intersectCells(surface, {{-3, 1.001, 1.001}, {1, 0, 0}}).hit.hit);
    QVERIFY(intersectCells(surface, {{-3, 0.999, 0.999}, {1, 0, 0}}).hit.hit);
}

void CellRaysTest::openEdgesAreWhole_data() {
    QTest::addColumn<double>("angle"); // between both faces
    QTest::addColumn<bool>("convex");
    for (const double angle : {5.0, 20.0, 45.0, 70.0, 90.0, 120.0, 160.0})
        for (const bool convex : {true, false})
            QTest::addRow("%s %g degrees", convex ? "convex" : "concave", angle) << angle << convex;
}

/// Where a boundary limit ends open surfaces: all surfels about an edge lie to one side of it, and no edge is a rim.
void CellRaysTest::openEdgesAreWhole() {
    QFETCH(double, angle);
    QFETCH(bool, convex);
    Random random(test::seed());
    constexpr double spacing = 0.08, radius = 1.2;
    const double half = angle / 2 * plane_solids::pi / 180, sign = convex ? 1 : -1;
    const std::vector<plane_solids::Plane> planes{{Vec3d{std::sin(half), -std::cos(half), 0} * -sign, 0},
                                                  {Vec3d{std::sin(half), std::cos(half), 0} * -sign, 0}};
    const SampledSolid s =
        sampled(convex ? plane_solids::intersection(planes) : plane_solids::unionOf(planes), radius, spacing, random);
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.17f; // about an acute edge o is up to 0.23 h
    definition.oneSheet = false;
    const CellSurface surface = *CellSurface::of(surface::Surface(tree::SurfelTree::build(s.surfels), definition));
    int rays = 0;
    for (int k = 0; rays < test::effort(120) && k < 20000; ++k) {
        const Vec3d edge{0, 0, random.uniform(-0.5, 0.5)};
        const Rayd ray =
            towards(edge + random.unitVector() * (random.uniform(0, 1.5) * spacing), random.unitVector(), 2);
        std::size_t plane = 0;
        const double t = s.solid.value(ray.origin) > 0 ? s.solid.hit(ray, plane) : -1;
        if (t < 0 || length(ray.at(t) - edge) > 2 * spacing ||
            std::abs(dot(s.solid.planes[plane].n, ray.direction)) < 0.05)
            continue;
        ++rays;
        const cells::CellHit exact = intersectCells(surface, ray);
        const base::Rayf rounded{base::cast<float>(ray.origin), base::cast<float>(ray.direction)};
        surface::RayHit<float> quick;
        intersect(surface, {&rounded, 1}, {}, {&quick, 1});
        const QByteArray where = QString("seed %1, ray %2").arg(test::seed()).arg(k).toUtf8();
        QVERIFY2(exact.hit.hit && quick.hit, where);
        QVERIFY2(std::abs(exact.hit.t - t) < 1e-3 * spacing, where);
        QVERIFY2(std::abs(static_cast<double>(quick.t) - t) < 1e-2 * spacing, where);
    }
    QVERIFY(rays > 10);
    // and the rim is where it was
    for (const plane_solids::Plane& plane : planes) {
        const Vec3d along = base::normalized(cross(plane.n, Vec3d{0, 0, 1}));
        const Vec3d out = along * (s.solid.onFace(&plane - planes.data(), along, 1e-6) ? 1.0 : -1.0);
        QVERIFY(!intersectCells(surface, towards(out * (radius + 1.2 * spacing), -plane.n, 0.2)).hit.hit);
        QVERIFY(intersectCells(surface, towards(out * (radius - 2 * spacing), -plane.n, 0.2)).hit.hit);
    }
}

/// A few surfels as a cell of their own, in nearly the plane of those about them: whichever of both is surface at a
/// place, one of them is.
void CellRaysTest::smallFlatCellsTearNoHoles() {
    Random random(test::seed());
    constexpr double spacing = 0.1;
    for (int round = 0; round < test::effort(60); ++round) {
        SampledSolid s = sampled(plane_solids::intersection({{{0, 0, 1}, 0}}), 1.2, spacing, random);
        const double size = spacing * random.uniform(0.5, 4);
        const Vec3d centre{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0};
        const Vec3d slope = base::perpendicular(Vec3d{0, 0, 1}) * std::tan(random.uniform(0, 0.2));
        const auto meeting = random.below(2) == 0 ? cells::Meeting::Convex : cells::Meeting::Concave;
        const bool oneFace = random.below(2) == 0;
        std::vector<cells::Label> labels(s.surfels.size());
        const auto inside = [&](const surfel::Surfel& each) {
            return base::distance(base::cast<double>(each.position), centre) < size;
        };
        for (std::size_t i = 0; i < labels.size(); ++i) {
            surfel::Surfel& own = s.surfels.items[i];
            labels[i].cell = labels[i].partner = inside(own) ? 1 : 0;
            labels[i].face = oneFace ? 0 : labels[i].cell;
            labels[i].sharpness = static_cast<std::uint8_t>(oneFace ? random.below(256) : 255);
            for (const surfel::Surfel& other : s.surfels.items)
                if (inside(other) != inside(own) && base::distance(own.position, other.position) < 2 * spacing) {
                    labels[i].partner = 1 - labels[i].cell;
                    labels[i].meeting = meeting;
                }
        }
        for (surfel::Surfel& each : s.surfels.items)
            if (inside(each)) {
                each.position.z = static_cast<float>(dot(slope, base::cast<double>(each.position) - centre));
                each.normal = base::cast<float>(base::normalized(Vec3d{0, 0, 1} - slope));
            }
        cells::setLabels(s.surfels, labels, true);
        const CellSurface surface = cellsOf(s.surfels);
        for (int k = 0; k < 200; ++k) {
            const Vec3d target = centre + Vec3d{random.uniform(-7, 7), random.uniform(-7, 7), 0} * spacing;
            const cells::CellHit hit = intersectCells(surface, towards(target, {0, 0, -1}, 1));
            const QByteArray where = QString("seed %1, round %2, ray %3: %4")
                                         .arg(test::seed())
                                         .arg(round)
                                         .arg(k)
                                         .arg(hit.hit.hit ? "off" : "lost")
                                         .toUtf8();
            QVERIFY2(hit.hit.hit && std::abs(hit.hit.position.z) < 1.2 * spacing, where);
        }
    }
}

void CellRaysTest::cellsEndAtFinerOnes_data() {
    QTest::addColumn<bool>("convex");
    QTest::newRow("cube") << true;
    QTest::newRow("L-block") << false;
}

/// One face has surfels so far apart that it goes on beyond the supports of those across its edges: it ends there all
/// the same, for rays in either precision, values and feet.
void CellRaysTest::cellsEndAtFinerOnes() {
    QFETCH(bool, convex);
    Random random(test::seed());
    const Solid solid = convex ? cube(0.5) : lBlock(0.6);
    constexpr double fine = 0.025, coarse = 0.15;
    constexpr std::uint32_t face = 4; // z is up
    surfel::SurfelList list = sampled(solid, 2, fine, random).surfels, mixed;
    mixed.layout = list.layout;
    const cells::LabelLayout labels = *cells::LabelLayout::of(*list.layout);
    for (std::size_t i = 0; i < list.size(); ++i)
        if (labels.at(list.extraOf(i)).cell != face)
            mixed.append(list.items[i], list.extraOf(i));
    list = sampled(solid, 2, coarse, random).surfels;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (labels.at(list.extraOf(i)).cell == face)
            mixed.append(list.items[i], list.extraOf(i));
    const CellSurface surface = cellsOf(mixed);
    const double top = solid.planes[face].d, reach = convex ? 0.5 : 0.6;
    std::vector<base::Rayf> rays;
    std::vector<double> expected;
    int beyond = 0;
    while (rays.size() < 2000) {
        const Vec3d x{random.uniform(-reach, reach) * 1.5, random.uniform(-reach, reach) * 1.5, top};
        const Vec3d d = normalized(Vec3d{random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4), -1});
        const Rayd ray{x - d * 2, d};
        std::size_t plane = 0;
        const double t = solid.hit(ray, plane), value = solid.value(x);
        if (std::abs(value) < 1e-3 && t < 0)
            continue;
        rays.push_back({base::cast<float>(ray.origin), base::cast<float>(d)});
        expected.push_back(t);
        if (value > 2 * fine && value < 0.3) {
            ++beyond;
            const cells::CellValue here = cells::evaluate(surface, x, surface::Need::Value);
            QVERIFY2(!(here.at.value < fine), QString("seed %1: %2, not %3, at %4 %5 %6 of cell %7")
                                                  .arg(test::seed())
                                                  .arg(here.at.value)
                                                  .arg(value)
                                                  .arg(x.x)
                                                  .arg(x.y)
                                                  .arg(x.z)
                                                  .arg(here.cell)
                                                  .toUtf8());
            const cells::CellFoot foot = cells::project(surface, x);
            QVERIFY(foot.projection.ok());
            // past a corner the largest height is no distance
            int past = 0;
            for (const Plane& each : solid.planes)
                past += each.f(x) > 1e-3;
            QVERIFY(past != 1 || std::abs(base::distance(foot.projection.foot, x) - value) < 0.5 * fine);
        }
    }
    QVERIFY(beyond > 100);
    std::vector<surface::RayHit<float>> hits(rays.size());
    cells::intersect(surface, rays, {}, hits);
    int wrong = 0, wrongInDouble = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto differs = [&](bool hit, double t) {
            return hit != (expected[i] > 0) || (hit && std::abs(t - expected[i]) > fine);
        };
        const auto exact = cells::intersectReference(
            surface, Rayd{base::cast<double>(rays[i].origin), base::cast<double>(rays[i].direction)}, {});
        wrong += differs(hits[i].hit, static_cast<double>(hits[i].t));
        wrongInDouble += differs(exact.hit, exact.t);
    }
    const QByteArray told = QString("seed %1: %2 and %3 of %4 rays")
                                .arg(test::seed())
                                .arg(wrong)
                                .arg(wrongInDouble)
                                .arg(rays.size())
                                .toUtf8();
    QVERIFY2(wrong <= 4 && wrongInDouble <= 4, told);
}

static const test::Registered<CellRaysTest> registered;
#include "cell_rays_test.moc"
