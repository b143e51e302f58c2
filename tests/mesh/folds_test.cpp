// Where near sheets meet and the definition ends: sound triangles, and vertices on one of the sheets.
#include "core/mesh/check.h"
#include "core/mesh/marching_cubes.h"
#include "mesh/models.h"
#include "support/registry.h"
#include "surface/scans.h"

#include <QtTest>

using mesh::MarchingOptions, mesh::MarchingReport, mesh::Mesh;

class FoldsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void doubleToriHaveGenusTwo_data();
    void doubleToriHaveGenusTwo();
    void trianglesWhereSpheresTouchHaveArea_data();
    void trianglesWhereSpheresTouchHaveArea();
    void verticesOfScansLieOnTheSurface_data();
    void verticesOfScansLieOnTheSurface();
};

namespace {

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
        QTest::addRow("smooth, %.1f", cell) << true << cell;
        QTest::addRow("with a seam, %.1f", cell) << false << cell;
    }
}

void FoldsTest::doubleToriHaveGenusTwo() {
    QFETCH(bool, smooth);
    QFETCH(double, cell);
    constexpr double spacing = 0.08;
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
    const surface::Surface surface = shapes::surfaceOf(list);
    const Mesh m = meshOf(surface, cell * spacing);
    const mesh::Topology topology = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
    QVERIFY(topology.manifold() && topology.foldLoops > 0);
    QCOMPARE(mesh::shapeOf(m).degenerate, std::size_t(0));
    const mesh::Deviation vertices = mesh::vertexDeviation(m, surface);
    QVERIFY2(vertices.max < 1e-2 * spacing && vertices.lost == 0, QByteArray::number(vertices.max / spacing));
}

void FoldsTest::verticesOfScansLieOnTheSurface_data() {
    QTest::addColumn<QString>("file");
    QTest::newRow("bunny") << QString("bunny/bun_zipper.ply");
    QTest::newRow("dragon") << QString("dragon_res2.ply");
}

void FoldsTest::verticesOfScansLieOnTheSurface() {
    if (test::dataFolder().empty())
        QSKIP("POINTCLAY_DATA names no folder of scans");
    QFETCH(QString, file);
    surfel::SurfelList points = scans::positionsOf(test::dataFolder() + "/" + file.toStdString());
    if (points.items.empty())
        QSKIP("no such scan in the folder");
    const surface::Surface surface = process::prepare(std::move(points), {});
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(surface, {}, report);
    QVERIFY(mesh::topologyOf(m.triangles, m.positions.size()).manifold());
    QCOMPARE(mesh::shapeOf(m).degenerate, std::size_t(0));
    const mesh::Deviation vertices = mesh::vertexDeviation(m, surface);
    QVERIFY2(vertices.max < 1e-2 * report.cell && vertices.lost == 0, QByteArray::number(vertices.max / report.cell));
}

static const test::Registered<FoldsTest> registered;
#include "folds_test.moc"
