// A triangulation under edits: it stays the manifold it was, and each edit does what it says.
#include "core/mesh/connectivity/triangulation.h"

#include "core/base/random.h"
#include "core/mesh/check/topology.h"
#include "mesh/meshes.h"
#include "support/registry.h"

#include <QtTest>
#include <set>

using mesh::Side, mesh::Triangle, mesh::Triangulation;

class TriangulationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void neighboursAgree_data();
    void neighboursAgree();
    void randomEditsKeepTheManifold_data() { neighboursAgree_data(); }
    void randomEditsKeepTheManifold();
    void flipsJoinTheApices();
    void flipsThatDoubleAnEdgeAreRefused();
    void splitsFillTheirFace();
    void collapsesThatPinchAreRefused();
    void earsLeaveTheirBoundary();
};

namespace {

mesh::Mesh shape(const std::string& name) {
    return name == "torus" ? meshes::torus(6, 9) : name == "moebius" ? meshes::moebius(9) : meshes::tetrahedron();
}

std::vector<Triangle> facesOf(const Triangulation& t) {
    std::vector<Triangle> out;
    for (std::uint32_t f = 0; f < t.faceCount(); ++f)
        if (t.alive(f))
            out.push_back(t.corners(f));
    return out;
}

mesh::Topology topologyOf(const Triangulation& t, std::size_t vertices) {
    return mesh::topologyOf(facesOf(t), vertices, {});
}

/// Every side is its neighbour's, with the same ends; one-rings hold all the faces at their vertex.
void verifyLinks(const Triangulation& t, std::size_t vertices) {
    std::vector<std::set<std::uint32_t>> at(vertices);
    for (std::uint32_t f = 0; f < t.faceCount(); ++f)
        for (int k = 0; k < 3 && t.alive(f); ++k) {
            const Side s{f, k}, other = t.across(s);
            at[t.apex(s)].insert(f);
            if (!other.exists())
                continue;
            QVERIFY(t.alive(other.face) && t.across(other) == s);
            QCOMPARE(std::minmax(t.from(s), t.to(s)), std::minmax(t.from(other), t.to(other)));
        }
    std::vector<std::uint32_t> ring;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        t.oneRing(v, ring);
        QCOMPARE(std::set<std::uint32_t>(ring.begin(), ring.end()), at[v]);
        QCOMPARE(ring.size(), at[v].size());
    }
}

} // namespace

void TriangulationTest::neighboursAgree_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"torus", "moebius", "tetrahedron"})
        QTest::addRow("%s", name) << QString(name);
}

void TriangulationTest::neighboursAgree() {
    QFETCH(QString, name);
    const mesh::Mesh m = shape(name.toStdString());
    const Triangulation t(m.triangles, m.positions.size());
    verifyLinks(t, m.positions.size());
    std::size_t boundary = 0;
    for (std::uint32_t f = 0; f < t.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            boundary += t.onBoundary(Side{f, k});
    QCOMPARE(boundary, mesh::topologyOf(m.triangles, m.positions.size(), {}).boundaryEdges);
}

void TriangulationTest::randomEditsKeepTheManifold() {
    QFETCH(QString, name);
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    const mesh::Mesh m = shape(name.toStdString());
    std::size_t vertices = m.positions.size();
    Triangulation t(m.triangles, vertices);
    const mesh::Topology before = topologyOf(t, vertices);
    int flips = 0, collapses = 0;
    for (int i = 0; i < test::effort(600); ++i) {
        Side s;
        do
            s = {static_cast<std::uint32_t>(random.below(t.faceCount())), static_cast<int>(random.below(3))};
        while (!t.alive(s.face));
        switch (random.below(5)) {
        case 0:
            t.splitFace(s.face, t.addVertex());
            ++vertices;
            break;
        case 1:
            t.splitSide(s, t.addVertex());
            ++vertices;
            break;
        case 2:
            flips += t.flip(s);
            break;
        default:
            collapses += t.collapse(t.from(s), t.to(s));
        }
        const mesh::Topology now = topologyOf(t, vertices);
        const QByteArray where = QByteArray("seed ") + QByteArray::number(seed) + " edit " + QByteArray::number(i);
        QVERIFY2(now.manifold(), where);
        QVERIFY2(now.euler() == before.euler() && now.boundaryLoops == before.boundaryLoops &&
                     now.orientable == before.orientable && now.components == 1,
                 where);
    }
    verifyLinks(t, vertices);
    QVERIFY(flips > 0 && collapses > 0);
}

void TriangulationTest::flipsJoinTheApices() {
    const std::vector<Triangle> two{{0, 1, 2}, {1, 0, 3}};
    Triangulation t(two, 4);
    QVERIFY(t.joined(0, 1) && !t.joined(2, 3));
    QVERIFY(t.flip({0, 2}));
    QVERIFY(!t.joined(0, 1) && t.joined(2, 3));
    QVERIFY(!t.flip({0, 0}) || !t.onBoundary(Side{0, 0}));
    const std::vector<Triangle> opposed{{0, 1, 2}, {0, 1, 3}}; // a neighbour that runs the other way
    Triangulation other(opposed, 4);
    QVERIFY(other.flip({0, 2}));
    QVERIFY(topologyOf(other, 4).opposedEdges == 0);
}

void TriangulationTest::flipsThatDoubleAnEdgeAreRefused() {
    const mesh::Mesh m = meshes::tetrahedron();
    Triangulation t(m.triangles, m.positions.size());
    for (std::uint32_t f = 0; f < 4; ++f)
        for (int k = 0; k < 3; ++k)
            QVERIFY(!t.flip({f, k}));
    QCOMPARE(facesOf(t), m.triangles);
}

void TriangulationTest::splitsFillTheirFace() {
    const std::vector<Triangle> one{{0, 1, 2}};
    Triangulation inside(one, 3);
    inside.splitFace(0, inside.addVertex());
    QCOMPARE(inside.faceCount(), 3u);
    std::vector<std::uint32_t> around;
    inside.neighbours(3, around);
    QCOMPARE(std::set<std::uint32_t>(around.begin(), around.end()), (std::set<std::uint32_t>{0, 1, 2}));
    QVERIFY(!inside.onBoundary(std::uint32_t(3)));
    Triangulation side(one, 3);
    side.splitSide({0, 0}, side.addVertex());
    QCOMPARE(side.faceCount(), 2u);
    QVERIFY(side.onBoundary(std::uint32_t(3)) && !side.joined(1, 2) && side.joined(0, 3));
}

/// Closed around a triangle that is no face: a neck.
void TriangulationTest::collapsesThatPinchAreRefused() {
    const mesh::Mesh m = meshes::torus(3, 7);
    Triangulation t(m.triangles, m.positions.size());
    // Vertices 0, 7 and 14 go round the tube.
    QVERIFY(t.joined(0, 7) && t.joined(7, 14) && t.joined(14, 0));
    QVERIFY(!t.collapse(0, 7));
    QCOMPARE(facesOf(t), m.triangles);
    const mesh::Mesh band = meshes::moebius(9); // one square across: edges across it have both ends on the boundary
    Triangulation narrow(band.triangles, band.positions.size());
    int refused = 0;
    for (std::uint32_t f = 0; f < narrow.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (const Side s{f, k}; !narrow.onBoundary(s))
                refused += !narrow.collapse(narrow.from(s), narrow.to(s));
    QCOMPARE(refused, static_cast<int>(2 * band.triangles.size()));
}

void TriangulationTest::earsLeaveTheirBoundary() {
    const std::vector<Triangle> two{{0, 1, 2}, {1, 0, 3}};
    Triangulation t(two, 4);
    t.removeEar(1);
    QVERIFY(!t.alive(1) && t.onBoundary(Side{0, 2}));
    std::vector<std::uint32_t> ring;
    t.oneRing(3, ring);
    QVERIFY(ring.empty());
    t.oneRing(0, ring);
    QCOMPARE(ring, std::vector<std::uint32_t>{0});
}

static const test::Registered<TriangulationTest> registered;
#include "triangulation_test.moc"
