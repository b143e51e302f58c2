// Where cells end: at seams, at open edges, beside patches of a few surfels and beside cells that are sampled more
// finely.
#include "core/cells/cell_rays.h"

#include "cells/solids.h"
#include "core/cells/cell_projection.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;
using base::Rayd;
using cells::CellSurface;

class CellEndsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void octantsKeepTheirSeams();
    void openEdgesAreWhole_data();
    void openEdgesAreWhole();
    void smallFlatCellsTearNoHoles();
    void cellsEndAtFinerOnes_data();
    void cellsEndAtFinerOnes();
};

/// An eighth of a ball: three quarters of discs and a part of a sphere.
void CellEndsTest::octantsKeepTheirSeams() {
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

void CellEndsTest::openEdgesAreWhole_data() {
    QTest::addColumn<double>("angle"); // between both faces
    QTest::addColumn<bool>("convex");
    for (const double angle : {5.0, 20.0, 45.0, 70.0, 90.0, 120.0, 160.0})
        for (const bool convex : {true, false})
            QTest::addRow("%s %g degrees", convex ? "convex" : "concave", angle) << angle << convex;
}

/// Where a boundary limit ends open surfaces: all surfels about an edge lie to one side of it, and no edge is a rim.
void CellEndsTest::openEdgesAreWhole() {
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
void CellEndsTest::smallFlatCellsTearNoHoles() {
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

void CellEndsTest::cellsEndAtFinerOnes_data() {
    QTest::addColumn<bool>("convex");
    QTest::newRow("cube") << true;
    QTest::newRow("L-block") << false;
}

/// One face has surfels so far apart that it goes on beyond the supports of those across its edges: it ends there all
/// the same, for rays in either precision, values and feet.
void CellEndsTest::cellsEndAtFinerOnes() {
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

static const test::Registered<CellEndsTest> registered;
#include "cell_ends_test.moc"
