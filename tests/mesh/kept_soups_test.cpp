// Of faces that were put together of parts, what stays as it is: vertices of parts that cross, and sheets beside a
// solid.
#include "core/mesh/check/topology.h"
#include "core/mesh/faces/open_faces.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/prepare.h"
#include "core/surface/surface.h"
#include "mesh/soups.h"
#include "support/registry.h"

#include <QTest>

using namespace soups;
using faces::FaceTopology, mesh::OpenedFaces;

class KeptSoupsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void keptVerticesOfCrossingPartsAreTheirUnion();
    void sheetsBesideASolidStayOpen();
};

/// Two rings in one plane enclose three holes together.
void KeptSoupsTest::keptVerticesOfCrossingPartsAreTheirUnion() {
    base::Random random(test::seed());
    const double apart = random.uniform(0.95, 1.05);
    Faces rings = faces::band(200, 80, false);
    const Faces other = rings;
    append(rings, other);
    for (std::size_t i = other.positions.size(); i < rings.positions.size(); ++i)
        rings.positions[i].x += static_cast<float>(apart);
    const OpenedFaces found = mesh::openFaces(rings.list(), rings.triangles, {}, {});
    QVERIFY(!found.sampled && found.closed);
    QVERIFY(found.points.size() < rings.positions.size());
    const auto depth = [](Vec3d p, double x) {
        p.x -= x;
        return 0.4 - std::hypot(std::hypot(p.x, p.y) - 1, p.z);
    };
    std::size_t left = 0;
    for (const base::Vec3f& p : rings.positions)
        left += std::min(depth(base::cast<double>(p), 0), depth(base::cast<double>(p), apart)) < -1e-3;
    for (const surfel::Surfel& s : found.points.items)
        QVERIFY(std::max(depth(base::cast<double>(s.position), 0), depth(base::cast<double>(s.position), apart)) <
                0.05); // an edge at most
    QVERIFY(found.points.size() >= left);
    process::PrepareOptions options;
    options.definition.boundary = surface::Boundary::None;
    mesh::MarchingReport report;
    mesh::MarchingOptions marching;
    marching.cell = 0.035;
    const mesh::Mesh m = mesh::marchingCubes(process::prepare(found.points, options), marching, report);
    const mesh::Topology t = mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
    QVERIFY2(t.manifold() && t.boundaryEdges == 0 && t.components == 1 && t.genus() == 3,
             QString("apart %1: %2 edges, %3 pieces, genus %4, seed %5")
                 .arg(apart)
                 .arg(t.boundaryEdges)
                 .arg(t.components)
                 .arg(t.genus().value_or(-1))
                 .arg(test::seed())
                 .toUtf8());
}

void KeptSoupsTest::sheetsBesideASolidStayOpen() {
    Faces faces = aligned({0, 0, 0}, {1, 1, 1}).faces();
    append(faces, {{{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
    append(faces, {{{0.5f, 1, 0.2f}, {0.5f, 1, 0.8f}, {0.5f, 2, 0.8f}}, {{0, 1, 2}}}); // one that stands on it
    const FaceTopology found = faces.topology();
    QVERIFY(!found.closed());
    QCOMPARE(found.triangles.size(), faces.triangles.size());
    Faces fin = aligned({0, 0, 0}, {1, 1, 1}).faces(); // at an edge of it, outside and inside
    fin.positions.push_back({0.5f, 0.5f, -1});
    fin.triangles.push_back({0, 1, 8});
    fin.positions.push_back({0.5f, 0.5f, 0.5f});
    fin.triangles.push_back({0, 1, 9});
    const FaceTopology beside = fin.topology();
    QVERIFY(!beside.closed());
    QCOMPARE(beside.inside, std::size_t(1));
    QCOMPARE(beside.triangles.size(), std::size_t(13));
}

static const test::Registered<KeptSoupsTest> registered;
#include "kept_soups_test.moc"
