// Meshes of walls that are thinner than surfels are apart.
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "mesh/solid_rows.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

using base::Vec3d, mesh::MarchingOptions, mesh::MarchingReport, mesh::Mesh, mesh::Topology;

class ThinWallsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void meshesOfThinWallsAreWhole_data();
    void meshesOfThinWallsAreWhole();
    void areaAndVolumeKnowThinWalls();
    void thickWallsHaveCubesOfOneSize();
};

namespace {

constexpr double spacing = test::sanitized ? 0.09 : solids::spacing;

/// A grid that no wall is in line with.
MarchingOptions anyGrid(base::Random& random) {
    MarchingOptions out;
    const Vec3d a = random.unitVector(), b = base::normalized(cross(a, random.unitVector())), c = cross(a, b);
    out.turned = {{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
    out.shift = {random.uniform(), random.uniform(), random.uniform()};
    return out;
}

solids::Solid plate(double thickness) {
    return {{solids::box({-0.5, -0.4, -thickness / 2}, {0.5, 0.4, thickness / 2})}, {}, 1, 0};
}

std::vector<solids::Row> rowsOf(double thickness) {
    return {{"plate", plate(thickness), true}, {"shell", solids::shell(thickness), true}};
}

surface::Surface sampled(const solids::Solid& solid, base::Random& random) {
    return solids::surfaceOf(solids::sampled(solid, {spacing, 1, 0, 0, {}}, random));
}

} // namespace

void ThinWallsTest::meshesOfThinWallsAreWhole_data() {
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < rowsOf(spacing).size(); ++i)
        QTest::addRow("%s", rowsOf(spacing)[i].name) << int(i);
}

void ThinWallsTest::meshesOfThinWallsAreWhole() {
    QFETCH(int, row);
    base::Random random(test::seed());
    const double thickness = random.uniform(0.5, 0.8) * spacing;
    const solids::Solid solid = rowsOf(thickness)[std::size_t(row)].solid;
    const surface::Surface surface = sampled(solid, random);
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(surface, anyGrid(random), report);
    const Topology t = solids::topologyOf(m);
    QVERIFY(solids::isClosed(t));
    QCOMPARE(t.components, solid.pieces);
    QCOMPARE(t.genus(), std::optional(solid.genus));
    QVERIFY(mesh::selfIntersections(m).empty());
}

/// A shell, whose area and volume are known.
void ThinWallsTest::areaAndVolumeKnowThinWalls() {
    base::Random random(test::seed());
    const double thickness = random.uniform(0.5, 0.8) * spacing, inner = 0.5 - thickness;
    const mesh::Extent found = mesh::extentOf(sampled(solids::shell(thickness), random));
    const double area = 4 * shapes::pi * (0.25 + inner * inner),
                 volume = 4 * shapes::pi / 3 * (0.125 - inner * inner * inner);
    QVERIFY(found.closed);
    QVERIFY2(std::abs(found.area / area - 1) < 0.01, QByteArray::number(found.area / area));
    QVERIFY2(std::abs(found.volume / volume - 1) < 0.05, QByteArray::number(found.volume / volume));
}

void ThinWallsTest::thickWallsHaveCubesOfOneSize() {
    base::Random random(test::seed());
    const surface::Surface surface = sampled(solids::shell(random.uniform(1.5, 3) * spacing), random);
    MarchingReport report;
    mesh::marchingCubes(surface, {}, report);
    QVERIFY(report.largestCell == report.cell);
}

static const test::Registered<ThinWallsTest> registered;
#include "thin_walls_test.moc"
