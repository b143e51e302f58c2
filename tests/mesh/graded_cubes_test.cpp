// Cubes as large as the surfels around are apart: what is dense keeps its shape, what is sparse stays light, and where
// cubes of two sizes meet the mesh is as whole as anywhere.
#include "core/base/parallel.h"
#include "core/mesh/cell_size.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/cube_levels.h"
#include "core/mesh/marching/marching_cubes.h"
#include "mesh/solid_rows.h"
#include "mesh/soups.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/thread_counts.h"

#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::MarchingOptions, mesh::MarchingReport, mesh::Topology;

class GradedCubesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void neighboursDifferByOneLevel();
    void denseBodiesThatTouchSparseOnesKeepTheirShape();
    void trianglesAreAsLargeAsSurfelsAreApart();
    void openSurfacesEndInTheirBoundaryAlone();
    void evenSurfelsHaveCubesOfOneSize();
    void threadsDoNotShow();
};

using solids::isClosed, solids::topologyOf;

namespace {

MarchingOptions anyGrid(base::Random& random) {
    MarchingOptions out;
    const Vec3d a = random.unitVector(), b = base::normalized(cross(a, random.unitVector())), c = cross(a, b);
    out.turned = {{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
    out.shift = {random.uniform(), random.uniform(), random.uniform()};
    return out;
}

solids::Sampling samplingOf(double spacing, double uneven = 1) {
    solids::Sampling out;
    out.spacing = spacing;
    out.uneven = uneven;
    return out;
}

QByteArray told(int round) {
    return "seed " + QByteArray::number(test::seed()) + " round " + QByteArray::number(round);
}

/// A box, and small ones that stand in a side of it: sampled as faces are, each by itself and one towards the other.
surface::Surface boxesOnABox(base::Random& random) {
    std::vector<soups::Box> boxes{soups::aligned({-1, -1, -1}, {1, 1, 1})};
    for (std::size_t i = 0, count = 1 + random.below(2); i < count; ++i) {
        const double size = random.uniform(0.02, 0.05), turn = random.uniform(0, 6.3);
        soups::Box box = soups::tilted(random, 0, 0.5 * size, size);
        box.centre = {i == 0 ? -0.5 : 0.5, random.uniform(-0.5, 0.5), 1};
        box.axes[0] = {std::cos(turn), std::sin(turn), 0};
        box.axes[1] = {-std::sin(turn), std::cos(turn), 0};
        box.axes[2] = {0, 0, 1};
        boxes.push_back(box);
    }
    const soups::Faces faces = soups::together(boxes);
    const auto found = mesh::openFaces(faces.list(), faces.triangles, {},
                                       {.use = mesh::FaceUse::Sample, .count = test::sanitized ? 5000u : 12000u});
    surface::SurfaceDefinition definition;
    definition.boundary = surface::Boundary::None;
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    definition.oneSheet = !found.apart;
    return {tree::SurfelTree::build(found.points), definition};
}

/// How far the nearest vertex is from a surfel, in its own spacings; the most of them, looking at some.
double farthestSurfel(const Mesh& m, const surface::Surface& surface) {
    const double perUnit = mesh::SurfaceTraits(surface).spacingsPerUnit;
    const surfel::SurfelList list = surface.tree().surfels();
    double most = 0;
    for (std::size_t i = 0; i < list.size(); i += 1 + list.size() / 1500) {
        double nearest = 1e300;
        for (const Vec3d& p : m.positions)
            nearest = std::min(nearest, distanceSq(p, base::cast<double>(list.items[i].position)));
        most = std::max(most, std::sqrt(nearest) / (perUnit * double(list.items[i].support)));
    }
    return most;
}

} // namespace

/// Over sides, edges and corners, whatever is asked for.
void GradedCubesTest::neighboursDifferByOneLevel() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(20); ++round) {
        constexpr int highest = 4, side = 3; // cubes of the highest level, along an axis
        std::vector<std::vector<mesh::BrickBits>> wanted(highest + 1);
        const auto count = 1 + random.below(4);
        for (std::size_t i = 0; i < count; ++i) {
            const int level = 1 + static_cast<int>(random.below(highest));
            const auto place = [&] { return static_cast<std::int32_t>(random.below(side << (highest - level))); };
            wanted[std::size_t(level)].push_back(mesh::bitsOf({place(), place(), place()}));
        }
        const mesh::CubeLevels levels(wanted);
        const auto levelAt = [&](mesh::GridIndex p) {
            int level = highest;
            while (levels.isHalved({p.x >> level, p.y >> level, p.z >> level}, level))
                --level;
            return level;
        };
        for (int i = 0; i < 3000; ++i) {
            const auto place = [&] { return static_cast<std::int32_t>(1 + random.below((side << highest) - 2)); };
            const auto step = [&] { return static_cast<std::int32_t>(random.below(3)) - 1; };
            const mesh::GridIndex p{place(), place(), place()}, q{p.x + step(), p.y + step(), p.z + step()};
            QVERIFY2(std::abs(levelAt(p) - levelAt(q)) <= 1, told(round));
        }
    }
}

/// In cubes of the large body's spacing the small ones were stumps, and surfels 10 of their own spacings off.
void GradedCubesTest::denseBodiesThatTouchSparseOnesKeepTheirShape() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 1 : 3); ++round) {
        const surface::Surface surface = boxesOnABox(random);
        MarchingReport report;
        const Mesh m = mesh::marchingCubes(surface, anyGrid(random), report);
        const Topology t = topologyOf(m);
        QVERIFY2(isClosed(t), told(round));
        QVERIFY2(mesh::selfIntersections(m).empty(), told(round));
        QVERIFY2(m.triangles.size() < 6 * surface.tree().size(), told(round));
        const double farthest = farthestSurfel(m, surface);
        QVERIFY2(farthest < 2, told(round) + " " + QByteArray::number(farthest));
    }
}

/// Of any solid, where spacing grows by 1:20 and more from end to end.
void GradedCubesTest::trianglesAreAsLargeAsSurfelsAreApart() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 1 : 3); ++round) {
        const double uneven = random.uniform(20, 30);
        const solids::Sampling sampling = samplingOf(test::sanitized ? 0.045 : 0.04, uneven);
        const solids::Solid solids[] = {
            {{solids::ball({}, 0.5)}, {}, 1, 0}, solids::drilled(0.2), {{solids::torus({}, 0.35, 0.15)}, {}, 1, 1}};
        const solids::Solid& solid = solids[random.below(std::size(solids))];
        const surfel::SurfelList list = solids::sampled(solid, sampling, random);
        MarchingReport report;
        const Mesh m = mesh::marchingCubes(solids::surfaceOf(list), anyGrid(random), report);
        const Topology t = topologyOf(m);
        QVERIFY2(isClosed(t), told(round));
        QVERIFY2(t.components == solid.pieces && t.genus() == solid.genus, told(round));
        QVERIFY2(mesh::selfIntersections(m).empty(), told(round));
        std::size_t small = 0, large = 0;
        for (const mesh::Triangle& triangle : m.triangles) {
            const Vec3d &a = m.positions[triangle[0]], &b = m.positions[triangle[1]], &c = m.positions[triangle[2]];
            const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
            const double spacing = sampling.at((a + b + c) / 3);
            small += longest < 0.35 * spacing;
            large += longest > 3.5 * spacing;
        }
        QVERIFY2(50 * large < m.triangles.size(), told(round) + " large " + QByteArray::number(qulonglong(large)));
        QVERIFY2(8 * small < m.triangles.size(), told(round) + " small " + QByteArray::number(qulonglong(small)));
        QVERIFY2(m.triangles.size() < 6 * list.size(), told(round));
    }
}

/// A bowl, denser towards one side: one loop, and no crack where sizes of cubes change.
void GradedCubesTest::openSurfacesEndInTheirBoundaryAlone() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(test::sanitized ? 1 : 3); ++round) {
        const solids::Sampling sampling = samplingOf(test::sanitized ? 0.045 : 0.04, random.uniform(20, 30));
        surfel::SurfelList list = solids::sampled({{solids::ball({}, 0.5)}, {}}, sampling, random);
        std::erase_if(list.items, [](const surfel::Surfel& s) { return s.position.z > 0.1f; });
        MarchingReport report;
        const Mesh m = mesh::marchingCubes(process::prepare(std::move(list), {}), anyGrid(random), report);
        const Topology t = topologyOf(m);
        QVERIFY2(t.manifold() && t.opposedEdges == 0 && t.improper == 0, told(round));
        QVERIFY2(report.largestCell > 2 * report.cell, told(round));
        QVERIFY2(t.components == 1, told(round) + " pieces " + QByteArray::number(qulonglong(t.components)));
        QVERIFY2(t.boundaryLoops == 1, told(round) + " loops " + QByteArray::number(qulonglong(t.boundaryLoops)));
        QVERIFY2(mesh::selfIntersections(m).empty(), told(round));
    }
}

/// So what is even, or nearly so, is meshed as ever.
void GradedCubesTest::evenSurfelsHaveCubesOfOneSize() {
    base::Random random(test::seed());
    for (const double uneven : {1.0, 2.0, 4.0}) {
        const surface::Surface surface =
            solids::surfaceOf(solids::sampled(solids::drilled(0.2), samplingOf(0.06, uneven), random));
        MarchingReport report;
        mesh::marchingCubes(surface, {}, report);
        QVERIFY2(report.largestCell == report.cell, told(int(uneven)));
        QCOMPARE(report.cell, mesh::usualCell(surface.tree()));
    }
}

void GradedCubesTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surface::Surface surface = boxesOnABox(random);
    std::vector<Mesh> meshes;
    for (const int threads : test::comparedThreads({3})) {
        base::setThreadCount(threads);
        MarchingReport report;
        meshes.push_back(mesh::marchingCubes(surface, {}, report));
    }
    base::setThreadCount(0);
    QVERIFY(meshes.front().positions == meshes.back().positions && meshes.front().triangles == meshes.back().triangles);
}

static const test::Registered<GradedCubesTest> registered;
#include "graded_cubes_test.moc"
