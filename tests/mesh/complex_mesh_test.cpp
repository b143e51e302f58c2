// Meshes of complexes: every curve a chain of edges that its patches share, closed where the complex is.
#include "core/mesh/complexes/complex_mesh.h"

#include "complexes/sample_complexes.h"
#include "core/mesh/check/check.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/extent/extent.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <QTest>

using base::Vec3d;
using complexes::Complex;
using mesh::Mesh;

class ComplexMeshTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedComplexesGiveClosedMeshes_data();
    void closedComplexesGiveClosedMeshes();
    void openOnesEndAtTheirCurves();
    void patchesThatMeetInCornersStayApart();
    void flatSolidsHaveTheirVolume();
    void everyPointIsAVertex();
    void threadsDoNotShow();
};

void ComplexMeshTest::closedComplexesGiveClosedMeshes_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<double>("volume");
    QTest::addColumn<double>("within");
    const double pi = 3.14159265358979;
    QTest::newRow("octant") << "octant" << pi / 6 << 0.01;
    if (test::sanitized) // minutes there
        return;
    QTest::newRow("icosahedron") << "icosahedron" << 2.5361507 << 1e-6;
    QTest::newRow("bulged") << "bulged" << 0.0 << 0.0;
    QTest::newRow("rounded") << "rounded" << 4 * pi / 3 << 0.02;
}

void ComplexMeshTest::closedComplexesGiveClosedMeshes() {
    QFETCH(QString, sample);
    QFETCH(double, volume);
    QFETCH(double, within);
    const surface::Surface surface = complex_models::surfaceOf(sample.toUtf8(), 2500);
    const Complex complex = *Complex::of(surface);
    for (const double cell : {0.0, 0.09}) {
        const Mesh mesh = mesh::meshOfComplex(complex, {cell});
        const mesh::Topology topology = mesh::topologyOf(mesh.triangles, mesh.positions.size(), mesh.kinds);
        QVERIFY(topology.manifold());
        QCOMPARE(topology.boundaryLoops, std::size_t(0));
        QCOMPARE(topology.euler(), 2LL);
        QCOMPARE(mesh::selfIntersections(mesh).size(), std::size_t(0));
        QVERIFY(mesh::shapeOf(mesh).leastAngle > 0.035);
        const double found = mesh::volumeOf(mesh);
        QVERIFY2(within == 0 ? found > 2.5 : std::abs(found / volume - 1) < within, qPrintable(QString::number(found)));
        QVERIFY(mesh::vertexDeviation(mesh, surface).max < 1e-9);
    }
}

void ComplexMeshTest::openOnesEndAtTheirCurves() {
    const Mesh square = mesh::meshOfComplex(complex_models::complexOf("square", 1500), {});
    const mesh::Topology flat = mesh::topologyOf(square.triangles, square.positions.size(), square.kinds);
    QVERIFY(flat.manifold());
    QCOMPARE(flat.boundaryLoops, std::size_t(1));
    QVERIFY2(std::abs(mesh::areaOf(square) - 4) < 1e-9, qPrintable(QString::number(mesh::areaOf(square))));
    for (std::size_t v = 0; v < square.positions.size(); ++v) {
        const Vec3d& p = square.positions[v];
        const bool rim = std::abs(std::abs(p.x) - 1) < 1e-9 || std::abs(std::abs(p.y) - 1) < 1e-9;
        QCOMPARE(square.kinds[v] == mesh::VertexKind::Limit, rim);
    }
    // acute corners, narrower than the cubes
    for (const std::size_t count : {1700, 2500, 3300}) {
        const Mesh cone = mesh::meshOfComplex(complex_models::complexOf("cone", count), {});
        const mesh::Topology round = mesh::topologyOf(cone.triangles, cone.positions.size(), cone.kinds);
        QVERIFY(round.manifold());
        QCOMPARE(round.boundaryLoops, std::size_t(1));
        QCOMPARE(round.euler(), 1LL);
        QCOMPARE(mesh::selfIntersections(cone).size(), std::size_t(0));
        const double slope = std::sqrt(1 + 1.2 * 1.2);
        QVERIFY2(std::abs(mesh::areaOf(cone) / (3.14159265 * slope) - 1) < 0.02,
                 qPrintable(QString::number(mesh::areaOf(cone))));
    }
}

void ComplexMeshTest::patchesThatMeetInCornersStayApart() {
    const Mesh gasket = mesh::meshOfComplex(complex_models::complexOf("gasket", 5000), {});
    const mesh::Topology topology = mesh::topologyOf(gasket.triangles, gasket.positions.size(), gasket.kinds);
    QCOMPARE(topology.nonManifoldEdges, std::size_t(0));
    const double whole = std::sqrt(3.0);
    QVERIFY2(std::abs(mesh::areaOf(gasket) - whole * 27 / 64) < 1e-6,
             qPrintable(QString::number(mesh::areaOf(gasket))));
}

void ComplexMeshTest::flatSolidsHaveTheirVolume() {
    const Mesh coarse = mesh::meshOfComplex(complex_models::complexOf("icosahedron", 600), {0.2});
    QVERIFY2(std::abs(mesh::volumeOf(coarse) - 2.5361507) < 1e-5,
             qPrintable(QString::number(mesh::volumeOf(coarse), 'g', 9)));
}

void ComplexMeshTest::everyPointIsAVertex() {
    for (const char* sample : {"octant", "cone", "bulged"}) {
        const Complex complex = complex_models::complexOf(sample, 2000);
        const Mesh mesh = mesh::meshOfComplex(complex, {});
        for (std::uint32_t c = 0; c < complex.cells().size(); ++c)
            if (complex[c].dimension == 0)
                QCOMPARE(std::count(mesh.positions.begin(), mesh.positions.end(), complex.place(c)), 1L);
    }
}

void ComplexMeshTest::threadsDoNotShow() {
    const Complex complex = complex_models::complexOf("octant", 1500);
    const auto work = [&] { return mesh::meshOfComplex(complex, {}); };
    const Mesh one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.positions == two.positions && one.triangles == two.triangles && one.normals == two.normals);
}

static const test::Registered<ComplexMeshTest> registered;
#include "complex_mesh_test.moc"
