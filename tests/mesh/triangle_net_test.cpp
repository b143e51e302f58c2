// A triangle net under edits: it stays the manifold it was, and each edit does what it says.
#include "core/mesh/delaunay/triangle_net.h"

#include "core/base/random.h"
#include "core/mesh/check/topology.h"
#include "mesh/meshes.h"
#include "support/registry.h"

#include <QtTest>
#include <set>

using mesh::Side, mesh::Triangle, mesh::TriangleNet;

class TriangleNetTest : public QObject {
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
    void earsLeaveTheirRim();
};

namespace {

mesh::Mesh shape(const std::string& name) {
    return name == "torus" ? meshes::torus(6, 9) : name == "moebius" ? meshes::moebius(9) : meshes::tetrahedron();
}

std::vector<Triangle> facesOf(const TriangleNet& net) {
    std::vector<Triangle> out;
    for (std::uint32_t f = 0; f < net.faceCount(); ++f)
        if (net.alive(f))
            out.push_back(net.corners(f));
    return out;
}

mesh::Topology topologyOf(const TriangleNet& net, std::size_t vertices) {
    return mesh::topologyOf(facesOf(net), vertices, {});
}

/// Every side is its neighbour's, with the same ends; fans hold all the faces at their vertex.
void verifyLinks(const TriangleNet& net, std::size_t vertices) {
    std::vector<std::set<std::uint32_t>> at(vertices);
    for (std::uint32_t f = 0; f < net.faceCount(); ++f)
        for (int k = 0; k < 3 && net.alive(f); ++k) {
            const Side s{f, k}, other = net.across(s);
            at[net.apex(s)].insert(f);
            if (!other.exists())
                continue;
            QVERIFY(net.alive(other.face) && net.across(other) == s);
            QCOMPARE(std::minmax(net.from(s), net.to(s)), std::minmax(net.from(other), net.to(other)));
        }
    std::vector<std::uint32_t> fan;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        net.fan(v, fan);
        QCOMPARE(std::set<std::uint32_t>(fan.begin(), fan.end()), at[v]);
        QCOMPARE(fan.size(), at[v].size());
    }
}

} // namespace

void TriangleNetTest::neighboursAgree_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"torus", "moebius", "tetrahedron"})
        QTest::addRow("%s", name) << QString(name);
}

void TriangleNetTest::neighboursAgree() {
    QFETCH(QString, name);
    const mesh::Mesh m = shape(name.toStdString());
    const TriangleNet net(m.triangles, m.positions.size());
    verifyLinks(net, m.positions.size());
    std::size_t rims = 0;
    for (std::uint32_t f = 0; f < net.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            rims += net.onRim(Side{f, k});
    QCOMPARE(rims, mesh::topologyOf(m.triangles, m.positions.size(), {}).boundaryEdges);
}

void TriangleNetTest::randomEditsKeepTheManifold() {
    QFETCH(QString, name);
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    const mesh::Mesh m = shape(name.toStdString());
    std::size_t vertices = m.positions.size();
    TriangleNet net(m.triangles, vertices);
    const mesh::Topology before = topologyOf(net, vertices);
    int flips = 0, collapses = 0;
    for (int i = 0; i < test::effort(600); ++i) {
        Side s;
        do
            s = {static_cast<std::uint32_t>(random.below(net.faceCount())), static_cast<int>(random.below(3))};
        while (!net.alive(s.face));
        switch (random.below(5)) {
        case 0:
            net.splitFace(s.face, net.addVertex());
            ++vertices;
            break;
        case 1:
            net.splitSide(s, net.addVertex());
            ++vertices;
            break;
        case 2:
            flips += net.flip(s);
            break;
        default:
            collapses += net.collapse(net.from(s), net.to(s));
        }
        const mesh::Topology now = topologyOf(net, vertices);
        const QByteArray where = QByteArray("seed ") + QByteArray::number(seed) + " edit " + QByteArray::number(i);
        QVERIFY2(now.manifold(), where);
        QVERIFY2(now.euler() == before.euler() && now.boundaryLoops == before.boundaryLoops &&
                     now.orientable == before.orientable && now.components == 1,
                 where);
    }
    verifyLinks(net, vertices);
    QVERIFY(flips > 0 && collapses > 0);
}

void TriangleNetTest::flipsJoinTheApices() {
    const std::vector<Triangle> two{{0, 1, 2}, {1, 0, 3}};
    TriangleNet net(two, 4);
    QVERIFY(net.joined(0, 1) && !net.joined(2, 3));
    QVERIFY(net.flip({0, 2}));
    QVERIFY(!net.joined(0, 1) && net.joined(2, 3));
    QVERIFY(!net.flip({0, 0}) || !net.onRim(Side{0, 0}));
    const std::vector<Triangle> opposed{{0, 1, 2}, {0, 1, 3}}; // a neighbour that runs the other way
    TriangleNet other(opposed, 4);
    QVERIFY(other.flip({0, 2}));
    QVERIFY(topologyOf(other, 4).opposedEdges == 0);
}

void TriangleNetTest::flipsThatDoubleAnEdgeAreRefused() {
    const mesh::Mesh m = meshes::tetrahedron();
    TriangleNet net(m.triangles, m.positions.size());
    for (std::uint32_t f = 0; f < 4; ++f)
        for (int k = 0; k < 3; ++k)
            QVERIFY(!net.flip({f, k}));
    QCOMPARE(facesOf(net), m.triangles);
}

void TriangleNetTest::splitsFillTheirFace() {
    const std::vector<Triangle> one{{0, 1, 2}};
    TriangleNet inside(one, 3);
    inside.splitFace(0, inside.addVertex());
    QCOMPARE(inside.faceCount(), 3u);
    std::vector<std::uint32_t> around;
    inside.neighbours(3, around);
    QCOMPARE(std::set<std::uint32_t>(around.begin(), around.end()), (std::set<std::uint32_t>{0, 1, 2}));
    QVERIFY(!inside.onRim(std::uint32_t(3)));
    TriangleNet side(one, 3);
    side.splitSide({0, 0}, side.addVertex());
    QCOMPARE(side.faceCount(), 2u);
    QVERIFY(side.onRim(std::uint32_t(3)) && !side.joined(1, 2) && side.joined(0, 3));
}

/// Closed around a triangle that is no face: a neck.
void TriangleNetTest::collapsesThatPinchAreRefused() {
    const mesh::Mesh m = meshes::torus(3, 7);
    TriangleNet net(m.triangles, m.positions.size());
    // Vertices 0, 7 and 14 go round the tube.
    QVERIFY(net.joined(0, 7) && net.joined(7, 14) && net.joined(14, 0));
    QVERIFY(!net.collapse(0, 7));
    QCOMPARE(facesOf(net), m.triangles);
    const mesh::Mesh band = meshes::moebius(9); // one square across: edges across it have both ends on the rim
    TriangleNet narrow(band.triangles, band.positions.size());
    int refused = 0;
    for (std::uint32_t f = 0; f < narrow.faceCount(); ++f)
        for (int k = 0; k < 3; ++k)
            if (const Side s{f, k}; !narrow.onRim(s))
                refused += !narrow.collapse(narrow.from(s), narrow.to(s));
    QCOMPARE(refused, static_cast<int>(2 * band.triangles.size()));
}

void TriangleNetTest::earsLeaveTheirRim() {
    const std::vector<Triangle> two{{0, 1, 2}, {1, 0, 3}};
    TriangleNet net(two, 4);
    net.removeEar(1);
    QVERIFY(!net.alive(1) && net.onRim(Side{0, 2}));
    std::vector<std::uint32_t> fan;
    net.fan(3, fan);
    QVERIFY(fan.empty());
    net.fan(0, fan);
    QCOMPARE(fan, std::vector<std::uint32_t>{0});
}

static const test::Registered<TriangleNetTest> registered;
#include "triangle_net_test.moc"
