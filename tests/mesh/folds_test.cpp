// Where near sheets meet and the definition ends: sound triangles, and vertices on one of the sheets.
#include "core/mesh/check/check.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/finish/trim_folds.h"
#include "core/mesh/marching/marching_cubes.h"
#include "mesh/models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "surface/scans.h"

#include <array>
#include <QTest>

using mesh::MarchingOptions, mesh::MarchingReport, mesh::Mesh;

class FoldsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void doubleToriHaveGenusTwo_data();
    void doubleToriHaveGenusTwo();
    void trianglesWhereSpheresTouchHaveArea_data();
    void trianglesWhereSpheresTouchHaveArea();
    void meshesOfScansAreSound_data();
    void meshesOfScansAreSound();
    void whatCutsBesideTheBoundaryIsLeftOut();
    void whatCutsElsewhereStays();
    void fansThatCutAreOpenedAgain();
};

namespace {

/// Squares of side 1 in the plane z = 0, each cut in two, seen from above.
Mesh plate(std::uint32_t side) {
    Mesh out;
    const std::uint32_t row = side + 1;
    for (std::uint32_t i = 0; i < row; ++i)
        for (std::uint32_t j = 0; j < row; ++j) {
            out.positions.push_back({double(j), double(i), 0});
            out.normals.push_back({0, 0, 1});
            const bool boundary = i == 0 || j == 0 || i == side || j == side;
            out.kinds.push_back(boundary ? mesh::VertexKind::Limit : mesh::VertexKind::Inner);
        }
    for (std::uint32_t i = 0; i < side; ++i)
        for (std::uint32_t j = 0; j < side; ++j) {
            const std::uint32_t at = i * row + j;
            out.triangles.push_back({at, at + 1, at + row + 1});
            out.triangles.push_back({at, at + row + 1, at + row});
        }
    return out;
}

/// The vertices that are on the surface.
Mesh withoutBridges(const Mesh& m) {
    Mesh out;
    for (std::size_t v = 0; v < m.positions.size(); ++v)
        if (m.kinds[v] != mesh::VertexKind::Bridge) {
            out.positions.push_back(m.positions[v]);
            out.normals.push_back(m.normals[v]);
            out.kinds.push_back(m.kinds[v]);
        }
    return out;
}

Mesh meshOf(const surface::Surface& surface, double cell) {
    MarchingOptions options;
    options.cell = cell;
    MarchingReport report;
    return mesh::marchingCubes(surface, options, report);
}

} // namespace

void FoldsTest::doubleToriHaveGenusTwo_data() {
    QTest::addColumn<bool>("smooth");
    QTest::addColumn<double>("cell");
    for (const double cell : {0.5, 1.0, 2.0}) {
        if (test::sanitized && cell < 1)
            continue;
        QTest::addRow("smooth, %.1f", cell) << true << cell;
        QTest::addRow("with a seam, %.1f", cell) << false << cell;
    }
}

void FoldsTest::doubleToriHaveGenusTwo() {
    QFETCH(bool, smooth);
    QFETCH(double, cell);
    constexpr double spacing = 0.1;
    const surface::Surface surface = smooth ? models::smoothDoubleTorus(spacing) : models::doubleTorus(spacing);
    const Mesh m = meshOf(surface, cell * spacing);
    const mesh::Report report = mesh::check(m, surface);
    QVERIFY(report.topology.manifold());
    QVERIFY(report.topology.orientable);
    QCOMPARE(report.topology.components, std::size_t(1));
    QCOMPARE(report.topology.boundaryEdges, std::size_t(0));
    QCOMPARE(report.topology.euler(), -2);
    QCOMPARE(report.topology.genus(), std::optional<long long>(2));
    QCOMPARE(report.selfIntersections, std::size_t(0));
    QVERIFY2(report.vertices.max < 1e-4 * spacing && report.vertices.lost == 0,
             QByteArray::number(report.vertices.max / spacing));
}

void FoldsTest::trianglesWhereSpheresTouchHaveArea_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<double>("cell");
    for (const double gap : {-0.3, 0.0})
        for (const double cell : {0.5, 1.0})
            QTest::addRow("%.1f, %.1f", gap, cell) << gap << cell;
}

/// Gap and cell in spacings.
void FoldsTest::trianglesWhereSpheresTouchHaveArea() {
    QFETCH(double, gap);
    QFETCH(double, cell);
    const double spacing = shapes::sphereSpacing(2000, 1);
    surfel::SurfelList list = shapes::sphere(2000, 1, 3.5 * spacing);
    for (std::size_t k = 0, n = list.size(); k < n; ++k) {
        surfel::Surfel other = list.items[k];
        other.position.x += static_cast<float>(2 + gap * spacing);
        list.items.push_back(other);
    }
    const surface::Surface surface = shapes::surfaceOf(list, shapes::bounded(10)); // closed ones have no folds
    const Mesh m = meshOf(surface, cell * spacing);
    const mesh::Topology topology = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
    QVERIFY(topology.manifold() && topology.foldLoops > 0);
    QCOMPARE(mesh::shapeOf(m).degenerate, std::size_t(0));
    const mesh::Deviation vertices = mesh::vertexDeviation(m, surface);
    QVERIFY2(vertices.max < 1e-2 * spacing && vertices.lost == 0, QByteArray::number(vertices.max / spacing));
}

void FoldsTest::meshesOfScansAreSound_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("bunny") << QString("bunny/bun_zipper.ply");
    QTest::newRow("dragon") << QString("dragon_res2.ply");
}

/// Manifold, on the surface, no triangle through another or without area.
void FoldsTest::meshesOfScansAreSound() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    QFETCH(QString, file);
    surfel::SurfelList points;
    if (const char* why = scans::load(file, points))
        QSKIP(why);
    const surface::Surface surface = process::prepare(std::move(points), {});
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(surface, {}, report);
    QVERIFY(mesh::topologyOf(m.triangles, m.positions.size()).manifold());
    QCOMPARE(mesh::shapeOf(m).degenerate, std::size_t(0));
    QCOMPARE(mesh::selfIntersections(m).size(), std::size_t(0));
    const mesh::Deviation vertices = mesh::vertexDeviation(withoutBridges(m), surface);
    // A vertex whose angles do not let it onto its sheet stands off at a fold: .03 cells of the dragon's, one of them.
    QVERIFY2(vertices.max < 5e-2 * report.cell && vertices.lost == 0, QByteArray::number(vertices.max / report.cell));
    QVERIFY2(vertices.hundredth < 1e-4 * report.cell, QByteArray::number(vertices.hundredth / report.cell));
}

/// A corner on the boundary of a plate lies over the plate.
void FoldsTest::whatCutsBesideTheBoundaryIsLeftOut() {
    Mesh m = plate(8);
    m.positions[1] = {2.4, 1.3, 0}; // of the first row
    QVERIFY(!mesh::selfIntersections(m).empty());
    const std::size_t before = m.triangles.size(), left = mesh::trimFolds(m, 1);
    QVERIFY(left > 0 && left < 8);
    QCOMPARE(m.triangles.size(), before - left);
    QCOMPARE(mesh::selfIntersections(m).size(), std::size_t(0));
    const mesh::Topology topology = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
    QVERIFY(topology.manifold());
    QCOMPARE(topology.euler(), 1);
    QCOMPARE(topology.boundaryLoops, std::size_t(1));
    QCOMPARE(topology.unused, std::size_t(0));
    QCOMPARE(mesh::trimFolds(m, 1), std::size_t(0));
}

/// Two plates through each other's middles: to leave out triangles there would make holes.
void FoldsTest::whatCutsElsewhereStays() {
    Mesh m = plate(8);
    const std::uint32_t count = static_cast<std::uint32_t>(m.positions.size());
    const Mesh other = plate(8);
    for (std::uint32_t v = 0; v < count; ++v) {
        m.positions.push_back({4.1, other.positions[v].x, 20 * (other.positions[v].y - 4.05)});
        m.normals.push_back({1, 0, 0});
        m.kinds.push_back(other.kinds[v]);
    }
    for (mesh::Triangle t : other.triangles)
        m.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    const std::size_t cuts = mesh::selfIntersections(m).size();
    QVERIFY(cuts > 0);
    mesh::trimFolds(m, 1);
    const mesh::Topology topology = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
    QVERIFY(topology.manifold());
    QCOMPARE(topology.euler(), 2);
    QCOMPARE(topology.boundaryLoops, std::size_t(2));
    QVERIFY(!mesh::selfIntersections(m).empty());
}

/// The middle of a plate drawn out over its other triangles.
void FoldsTest::fansThatCutAreOpenedAgain() {
    for (const bool cuts : {true, false}) {
        Mesh m = plate(8);
        const std::uint32_t middle = 4 * 9 + 4;
        if (cuts)
            m.positions[middle] = {7.6, 7.4, 0};
        const std::size_t before = m.triangles.size();
        QCOMPARE(mesh::reopenCut(m, std::array{middle}, 4), std::size_t(cuts ? 1 : 0));
        const mesh::Topology topology = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
        QVERIFY(topology.manifold());
        QCOMPARE(topology.boundaryLoops, std::size_t(cuts ? 2 : 1));
        QCOMPARE(topology.foldLoops, std::size_t(cuts ? 1 : 0));
        QCOMPARE(m.triangles.size(), before - (cuts ? 6 : 0));
        QCOMPARE(mesh::selfIntersections(m).size(), std::size_t(0));
    }
}

static const test::Registered<FoldsTest> registered;
#include "folds_test.moc"
