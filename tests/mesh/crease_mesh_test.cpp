// Meshes of models with cells: vertices on faces, seams and corners, every seam a chain of edges, nothing torn.
#include "core/base/parallel.h"
#include "core/mesh/check/check.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/connectivity/triangulation.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/marching/marching_cubes.h"

#include "cells/solids.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Random, base::Vec3d, mesh::Mesh;
using plane_solids::SampledSolid;

class CreaseMeshTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void solidsKeepTheirEdges_data();
    void solidsKeepTheirEdges();
    void everyCornerHasOneVertex();
    void octantsKeepTheirEdges();
    void narrowSolidsDoNotCutThemselves();
    void threadsDoNotShow();
    void withoutLabelsNothingChanges();
};

namespace {

constexpr double spacing = 0.1;

enum class Method { MarchingCubes, Delaunay };

/// `cell`: the side of cubes, or the size of triangles.
Mesh meshOf(const surface::Surface& surface, double cell, Method method = Method::MarchingCubes) {
    if (method == Method::Delaunay) {
        mesh::DelaunayOptions options;
        options.size = cell;
        mesh::DelaunayReport report;
        return mesh::restrictedDelaunay(surface, options, report);
    }
    mesh::MarchingOptions options;
    options.cell = cell;
    mesh::MarchingReport report;
    return mesh::marchingCubes(surface, options, report);
}

/// Edges whose triangles differ by more than 25 degrees.
struct Creases {
    double length = 0;
    int ends = 0, strays = 0; ///< ends of them; those that are not on two planes of the solid
};

Creases creasesOf(const Mesh& mesh, const plane_solids::Solid& solid) {
    const mesh::Triangulation t(mesh);
    const auto normal = [&](std::uint32_t f) {
        const auto& c = t.corners(f);
        return base::normalized(
            cross(mesh.positions[c[1]] - mesh.positions[c[0]], mesh.positions[c[2]] - mesh.positions[c[0]]));
    };
    Creases out;
    t.forEdges([&](const mesh::Side& s) {
        const mesh::Side other = t.across(s);
        if (!other.exists() || dot(normal(s.face), normal(other.face)) > 0.906)
            return;
        out.length += base::distance(mesh.positions[t.from(s)], mesh.positions[t.to(s)]);
        for (const std::uint32_t v : {t.from(s), t.to(s)}) {
            const auto on =
                std::count_if(solid.planes.begin(), solid.planes.end(), [&](const plane_solids::Plane& plane) {
                    return std::abs(plane.f(mesh.positions[v])) < 1e-3 * spacing;
                });
            ++out.ends;
            out.strays += on < 2 ? 1 : 0;
        }
    });
    return out;
}

QString told(const mesh::Topology& t, const Creases& c, std::size_t cuts) {
    return QString("seed %1: loops %2, manifold %3, genus %4, cuts %5, creases %6 long, %7 of %8 ends stray")
        .arg(test::seed())
        .arg(t.boundaryLoops)
        .arg(t.manifold())
        .arg(t.genus().value_or(-1))
        .arg(cuts)
        .arg(c.length)
        .arg(c.strays)
        .arg(c.ends);
}

} // namespace

void CreaseMeshTest::solidsKeepTheirEdges_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("cell"); // in spacings
    QTest::addColumn<Method>("method");
    const auto rows = [](const QByteArray& how, double cell, Method method) {
        QTest::newRow("cube" + how) << 0 << cell << method;
        QTest::newRow("L-block" + how) << 1 << cell << method;
        QTest::newRow("random polyhedron" + how) << 2 << cell << method;
    };
    rows(" 1", 1, Method::MarchingCubes);
    rows(" 1.7", 1.7, Method::MarchingCubes);
    rows(" delaunay 1", 1, Method::Delaunay);
    rows(" delaunay 3", 3, Method::Delaunay);
}

void CreaseMeshTest::solidsKeepTheirEdges() {
    QFETCH(int, kind);
    QFETCH(double, cell);
    QFETCH(Method, method);
    if (test::sanitized && (kind != 0 || cell != 1))
        return;
    Random random(test::seed());
    const plane_solids::Solid solid = kind == 0   ? plane_solids::cube(0.8)
                                      : kind == 1 ? plane_solids::lBlock(0.9)
                                                  : plane_solids::polyhedron(random);
    const SampledSolid s = plane_solids::sampled(solid, 2.4, spacing, random);
    const surface::Surface surface = plane_solids::surfaceOf(s.surfels);
    const Mesh mesh = meshOf(surface, cell * spacing, method);
    const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size());
    const std::size_t cuts = mesh::selfIntersections(mesh).size();
    const Creases creases = creasesOf(mesh, solid);
    const QByteArray all = told(topology, creases, cuts).toUtf8();
    QVERIFY2(topology.manifold() && topology.boundaryLoops == 0 && topology.genus() == 0, all);
    QCOMPARE(cuts, std::size_t(0));
    QVERIFY2(creases.ends > 100 && creases.strays <= creases.ends / 200, all);
    if (kind != 2) {
        const double whole = kind == 0 ? 12 * 1.6 : 22 * 0.9;
        QVERIFY2(std::abs(creases.length - whole) < 0.01 * whole, all);
    }
    double worst = 0;
    for (const Vec3d& each : mesh.positions)
        worst = std::max(worst, std::abs(solid.value(each)));
    QVERIFY2(worst < 0.02 * spacing, QByteArray::number(worst / spacing) + " spacings off; " + all);
}

/// Triangles beside each other that see the same corner used to make two, which cut each other and were taken back.
void CreaseMeshTest::everyCornerHasOneVertex() {
    constexpr std::array outline{std::array{-.9, -.9}, std::array{.9, -.9}, std::array{.9, 0.},
                                 std::array{0., 0.},   std::array{0., .9},  std::array{-.9, .9}};
    Random random(test::seed());
    for (int round = 0; round < test::effort(8); ++round) {
        const SampledSolid s = plane_solids::sampled(plane_solids::lBlock(0.9), 2.4, spacing, random);
        const surface::Surface surface = plane_solids::surfaceOf(s.surfels);
        for (const Method method : {Method::MarchingCubes, Method::Delaunay}) {
            const Mesh mesh = meshOf(surface, random.uniform(1, 2) * spacing, method);
            for (const auto& [x, y] : outline)
                for (const double z : {-.45, .45}) {
                    const auto there = std::count_if(mesh.positions.begin(), mesh.positions.end(), [&](const Vec3d& v) {
                        return base::distance(v, {x, y, z}) < 1e-3 * spacing;
                    });
                    const QString where("seed %1, round %2: %3 vertices at %4 %5 %6");
                    QVERIFY2(there == 1, where.arg(test::seed()).arg(round).arg(there).arg(x).arg(y).arg(z).toUtf8());
                }
        }
    }
}

/// Three planes and a ball: seams that are bent.
void CreaseMeshTest::octantsKeepTheirEdges() {
    constexpr double octantSpacing = 0.06;
    Random random(test::seed());
    const surface::Surface surface = plane_solids::surfaceOf(plane_solids::octant(octantSpacing, random));
    const plane_solids::Solid planes = plane_solids::intersection({{{-1, 0, 0}, 0}, {{0, -1, 0}, 0}, {{0, 0, -1}, 0}});
    const Mesh mesh = meshOf(surface, octantSpacing);
    const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size());
    const std::size_t cuts = mesh::selfIntersections(mesh).size();
    const Creases creases = creasesOf(mesh, planes);
    const QByteArray all = told(topology, creases, cuts).toUtf8();
    QVERIFY2(topology.manifold() && topology.boundaryLoops == 0 && topology.genus() == 0 && cuts == 0, all);
    constexpr double whole = 3 + 3 * plane_solids::pi / 2;
    QVERIFY2(std::abs(creases.length - whole) < 0.02 * whole, all);
    for (const Vec3d& x : mesh.positions)
        QVERIFY2(std::abs(std::max(planes.value(x), length(x) - 1)) < 0.1 * octantSpacing, all);
}

/// Whatever is narrower than an edge: fins, slender tips with many faces, facets of a spacing or two.
void CreaseMeshTest::narrowSolidsDoNotCutThemselves() {
    Random random(test::seed());
    int sharpened = 0;
    const int rounds = test::effort(12);
    for (int round = 0; round < rounds; ++round) {
        plane_solids::Solid solid;
        const double s = random.uniform(0.1, 0.3);
        switch (round % 3) {
        case 0:
            solid = plane_solids::polyhedron(random);
            break;
        case 1:
            solid = plane_solids::pyramid(3 + static_cast<int>(random.below(7)), random.uniform(0.3, 0.9),
                                          random.uniform(0.3, 1.5));
            break;
        default:
            solid = plane_solids::cube(0.8);
            solid.planes[4].d = solid.planes[5].d = s * random.uniform(0.4, 2);
        }
        const SampledSolid sampled = plane_solids::sampled(solid, 2.4, s, random);
        const surface::Surface surface = plane_solids::surfaceOf(sampled.surfels);
        mesh::MarchingOptions plain;
        plain.cell = random.uniform(0.5, 1.2) * s;
        plain.creases = false;
        mesh::MarchingReport report;
        const Mesh smooth = mesh::marchingCubes(surface, plain, report), sharp = meshOf(surface, plain.cell);
        const auto before = mesh::topologyOf(smooth.triangles, smooth.positions.size());
        const auto after = mesh::topologyOf(sharp.triangles, sharp.positions.size());
        const QByteArray where = QString("seed %1, round %2").arg(test::seed()).arg(round).toUtf8();
        QVERIFY2(mesh::selfIntersections(sharp).size() <= mesh::selfIntersections(smooth).size(), where);
        QVERIFY2(after.manifold() == before.manifold() && after.boundaryLoops == before.boundaryLoops &&
                     after.genus() == before.genus(),
                 where);
        sharpened += sharp.positions != smooth.positions ? 1 : 0;
    }
    QVERIFY2(3 * sharpened >= 2 * rounds, QString::number(sharpened).toUtf8());
}

void CreaseMeshTest::threadsDoNotShow() {
    Random random(3);
    const SampledSolid s = plane_solids::sampled(plane_solids::cube(0.5), 1, spacing, random);
    const surface::Surface surface = plane_solids::surfaceOf(s.surfels);
    const auto with = [&](int threads) {
        base::setThreadCount(threads);
        return meshOf(surface, spacing);
    };
    const int before = base::threadCount();
    const Mesh one = with(1), two = with(2);
    base::setThreadCount(before);
    QVERIFY(one.positions == two.positions && one.triangles == two.triangles);
}

void CreaseMeshTest::withoutLabelsNothingChanges() {
    Random random(3);
    const SampledSolid s = plane_solids::sampled(plane_solids::cube(0.5), 1, spacing, random);
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    surfel::SurfelList bare;
    bare.layout = layout;
    for (const surfel::Surfel& each : s.surfels.items)
        bare.append(each, {});
    mesh::MarchingOptions options;
    mesh::MarchingReport report;
    const Mesh with = mesh::marchingCubes(plane_solids::surfaceOf(bare), options, report);
    options.creases = false;
    const Mesh without = mesh::marchingCubes(plane_solids::surfaceOf(bare), options, report);
    const Mesh smooth = mesh::marchingCubes(plane_solids::surfaceOf(s.surfels), options, report);
    QVERIFY(with.positions == without.positions && with.triangles == without.triangles);
    QVERIFY(with.positions == smooth.positions && with.triangles == smooth.triangles);
}

static const test::Registered<CreaseMeshTest> registered;
#include "crease_mesh_test.moc"
