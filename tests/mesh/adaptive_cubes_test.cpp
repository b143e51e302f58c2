// Cubes of several sizes: manifold without cracks, fewer where the surface is flat, within the tolerance.
#include "core/mesh/check/check.h"
#include "core/mesh/marching/marching_cubes.h"
#include "support/registry.h"
#include "surface/bounded.h"
#include "surface/shapes.h"

#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::MarchingOptions, mesh::MarchingReport, mesh::Topology;

class AdaptiveCubesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void trianglesStayWithinTheTolerance();
    void theToleranceHoldsOnBumps();
    void flatPartsHaveLargeCubes();
    void rimsStayAsTheyAre();
    void anyGridIsManifold();
    void tolerancesBelowWhatCubesReachChangeNothing();
};

namespace {

constexpr double spacing = 0.06;

Topology topologyOf(const Mesh& m) {
    return mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
}

surface::Surface torus() {
    return shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing));
}

MarchingOptions adaptive(double cell, double tolerance) {
    MarchingOptions out;
    out.cell = cell * spacing;
    out.adaptive = tolerance * spacing;
    return out;
}

/// Of the torus' own surface, which the definition keeps to far less than a tolerance.
double farthestCentre(const Mesh& m) {
    double most = 0;
    for (const mesh::Triangle& t : m.triangles) {
        const Vec3d c = (m.positions[t[0]] + m.positions[t[1]] + m.positions[t[2]]) / 3;
        most = std::max(most, std::abs(std::hypot(std::hypot(c.x, c.y) - 1, c.z) - 0.4));
    }
    return most;
}

} // namespace

void AdaptiveCubesTest::trianglesStayWithinTheTolerance() {
    const surface::Surface surface = torus();
    MarchingReport report;
    std::size_t before = mesh::marchingCubes(surface, adaptive(0.5, 0), report).triangles.size();
    for (const double tolerance : {0.05, 0.15, 0.4}) {
        const Mesh m = mesh::marchingCubes(surface, adaptive(0.5, tolerance), report);
        const Topology topology = topologyOf(m);
        QVERIFY(topology.manifold());
        QCOMPARE(topology.euler(), 0);
        QCOMPARE(topology.boundaryEdges, std::size_t(0));
        QCOMPARE(topology.opposedEdges, std::size_t(0));
        QCOMPARE(topology.unused, std::size_t(0));
        QVERIFY2(farthestCentre(m) < tolerance * spacing, QByteArray::number(farthestCentre(m) / spacing));
        QVERIFY2(10 * m.triangles.size() < 7 * before, QByteArray::number(m.triangles.size()));
        QVERIFY(report.largestCell >= 2 * report.cell);
        before = m.triangles.size();
    }
}

/// Of all that the finest cubes keep.
void AdaptiveCubesTest::theToleranceHoldsOnBumps() {
    const unsigned long long seed = test::seed();
    for (int i = 0; i < test::effort(5); ++i) {
        surfel::SurfelList list = shapes::torus(1, 0.4, spacing, 3.5 * spacing);
        base::Random random(seed + static_cast<unsigned long long>(i));
        const double noise = random.uniform(0.02, 0.1) * spacing, tolerance = random.uniform(0.05, 0.3) * spacing;
        list = shapes::jittered(list, noise, seed + static_cast<unsigned long long>(i));
        const surface::Surface surface =
            shapes::surfaceOf(list, i % 2 ? shapes::bounded(0.5f) : surface::SurfaceDefinition{});
        MarchingReport report;
        MarchingOptions options = adaptive(0.5, 0);
        const Mesh fine = mesh::marchingCubes(surface, options, report);
        const double finest = mesh::faceDeviation(fine, surface).max;
        options.adaptive = std::max(tolerance, 1.1 * finest);
        const Mesh m = mesh::marchingCubes(surface, options, report);
        const mesh::Deviation found = mesh::faceDeviation(m, surface);
        const auto where = "seed " + QByteArray::number(seed) + " round " + QByteArray::number(i) + ": " +
                           QByteArray::number(found.max / options.adaptive);
        QVERIFY2(found.lost == 0 && found.max <= 1.02 * options.adaptive, where);
        QVERIFY2(m.triangles.size() < fine.triangles.size(), where);
    }
}

/// But beside the boundary.
void AdaptiveCubesTest::flatPartsHaveLargeCubes() {
    const surface::Surface plate = shapes::surfaceOf(shapes::plane(30, spacing, 3.5 * spacing), shapes::bounded(0.3f));
    MarchingReport coarse, fine;
    const std::size_t many = mesh::marchingCubes(plate, adaptive(0.5, 0), fine).triangles.size();
    const Mesh m = mesh::marchingCubes(plate, adaptive(0.5, 0.01), coarse);
    QCOMPARE(topologyOf(m).boundaryLoops, std::size_t(1));
    QVERIFY2(5 * m.triangles.size() < many, QByteArray::number(m.triangles.size()) + " " + QByteArray::number(many));
    QVERIFY(coarse.largestCell >= 8 * coarse.cell);
    QVERIFY(coarse.cubes < fine.cubes);
    for (const Vec3d& p : m.positions)
        QVERIFY(std::abs(p.z) < 1e-4 * spacing);
}

void AdaptiveCubesTest::rimsStayAsTheyAre() {
    surfel::SurfelList half;
    half.layout = shapes::layout(true, true);
    for (const surfel::Surfel& s : shapes::sphere(3000, 1, 3.5 * spacing).items)
        if (s.position.z > 0)
            half.items.push_back(s);
    const surface::Surface surface = shapes::surfaceOf(half, shapes::bounded(0.3f));
    MarchingReport even, varied;
    const Topology all = topologyOf(mesh::marchingCubes(surface, adaptive(0.5, 0), even));
    const Topology some = topologyOf(mesh::marchingCubes(surface, adaptive(0.5, 0.3), varied));
    QCOMPARE(some.boundaryEdges, all.boundaryEdges);
    QCOMPARE(some.boundaryLoops, std::size_t(1));
    QCOMPARE(some.euler(), 1);
    QCOMPARE(varied.limitEnds, even.limitEnds);
    QVERIFY(2 * some.faces < all.faces);
}

/// Noise, two sheets, boundaries and folds.
void AdaptiveCubesTest::anyGridIsManifold() {
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int i = 0; i < test::effort(6); ++i) {
        const double s = shapes::sphereSpacing(900, 1);
        surfel::SurfelList list = shapes::sphere(900, 1, 3.5 * s);
        for (std::size_t k = 0, n = list.size(); k < n; ++k) {
            surfel::Surfel other = list.items[k];
            other.position.x += 2.0f + static_cast<float>(random.uniform(-0.3, 1) * s);
            list.items.push_back(other);
        }
        list = shapes::jittered(list, random.uniform(0, 0.3) * s, seed + static_cast<unsigned long long>(i));
        list.layout = shapes::layout(true, i % 3 != 0);
        MarchingOptions options;
        options.cell = random.uniform(0.4, 1) * s;
        options.adaptive = random.uniform(0.05, 1) * s;
        const Vec3d x = random.unitVector(), y = base::normalized(cross(x, random.unitVector())), z = cross(x, y);
        options.turned = {{{x.x, x.y, x.z}, {y.x, y.y, y.z}, {z.x, z.y, z.z}}};
        options.shift = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        MarchingReport report;
        const surface::Surface surface =
            shapes::surfaceOf(list, i % 2 ? shapes::bounded(0.2f) : surface::SurfaceDefinition{});
        const Topology topology = topologyOf(mesh::marchingCubes(surface, options, report));
        const auto where = QByteArray("seed ") + QByteArray::number(seed) + " round " + QByteArray::number(i);
        QVERIFY2(topology.nonManifoldEdges == 0 && topology.nonManifoldVertices == 0 && topology.improper == 0, where);
        QVERIFY2(topology.faces > 200, where);
    }
}

void AdaptiveCubesTest::tolerancesBelowWhatCubesReachChangeNothing() {
    const surface::Surface surface = torus();
    MarchingReport report;
    const Mesh even = mesh::marchingCubes(surface, adaptive(1, 0), report);
    const Mesh varied = mesh::marchingCubes(surface, adaptive(1, 1e-6), report);
    QVERIFY(even.triangles == varied.triangles);
    QVERIFY(even.positions == varied.positions);
    QCOMPARE(report.largestCell, report.cell);
}

static const test::Registered<AdaptiveCubesTest> registered;
#include "adaptive_cubes_test.moc"
