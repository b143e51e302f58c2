#include "core/base/random.h"
#include "core/mesh/check/topology.h"

#include "mesh/meshes.h"
#include "support/registry.h"
#include <QTest>
#include <set>

using mesh::Mesh, mesh::Topology, mesh::Triangle, mesh::topologyOf;

class TopologyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aTetrahedronIsAClosedBall();
    void aTorusHasOneHandle();
    void aDoubleTorusHasTwo();
    void aMoebiusBandHasOneSideAndOneBoundaryLoop();
    void flippedTrianglesAreOpposedNotOneSided();
    void tetrahedraSharingAnEdgeAreNotManifold();
    void tetrahedraSharingAVertexAreNotManifold();
    void loopsOfAPinchedVertexAreOneWalk();
    void foldLoopsAreThoseWithFoldVertices();
    void improperTrianglesAndUnusedVerticesAreCounted();
    void wrongNumbersAreRefused();
    void randomHolesAgreeWithBruteForce();
};

namespace {

Topology of(const Mesh& m) {
    return topologyOf(m.triangles, m.positions.size(), m.kinds);
}

/// Two tori with a triangle of each taken out and the edges of the holes glued.
Mesh doubleTorus() {
    const Mesh one = meshes::torus(8, 12);
    Mesh out = meshes::together(one, one);
    const auto half = static_cast<std::uint32_t>(one.positions.size());
    const Triangle hole = out.triangles.front();
    std::erase(out.triangles, hole);
    std::erase(out.triangles, Triangle{hole[0] + half, hole[1] + half, hole[2] + half});
    for (const std::uint32_t v : hole) // the second torus's triangle, mirrored onto the first's
        out = meshes::joined(out, v + half, v);
    for (std::size_t f = out.triangles.size() / 2; f < out.triangles.size(); ++f)
        std::swap(out.triangles[f][1], out.triangles[f][2]);
    return out;
}

} // namespace

void TopologyTest::aTetrahedronIsAClosedBall() {
    const Topology t = of(meshes::tetrahedron());
    QCOMPARE(t.vertices, std::size_t(4));
    QCOMPARE(t.edges, std::size_t(6));
    QCOMPARE(t.faces, std::size_t(4));
    QCOMPARE(t.components, std::size_t(1));
    QCOMPARE(t.boundaryLoops, std::size_t(0));
    QCOMPARE(t.euler(), 2LL);
    QCOMPARE(t.genus(), std::optional<long long>(0));
    QVERIFY(t.manifold() && t.orientable && t.opposedEdges == 0);
    const Topology two = of(meshes::together(meshes::tetrahedron(), meshes::tetrahedron()));
    QCOMPARE(two.components, std::size_t(2));
    QCOMPARE(two.euler(), 4LL);
    QCOMPARE(two.genus(), std::optional<long long>(0));
}

void TopologyTest::aTorusHasOneHandle() {
    const Topology t = of(meshes::torus(8, 12));
    QCOMPARE(t.euler(), 0LL);
    QCOMPARE(t.genus(), std::optional<long long>(1));
    QVERIFY(t.manifold() && t.orientable && t.opposedEdges == 0 && t.boundaryEdges == 0);
}

void TopologyTest::aDoubleTorusHasTwo() {
    const Topology t = of(doubleTorus());
    QCOMPARE(t.euler(), -2LL);
    QCOMPARE(t.genus(), std::optional<long long>(2));
    QVERIFY(t.manifold() && t.orientable && t.opposedEdges == 0 && t.boundaryEdges == 0);
}

void TopologyTest::aMoebiusBandHasOneSideAndOneBoundaryLoop() {
    const Topology t = of(meshes::moebius(20));
    QVERIFY(t.manifold());
    QVERIFY(!t.orientable);
    QVERIFY(!t.mixed);
    QVERIFY(t.opposedEdges > 0);
    QCOMPARE(t.boundaryLoops, std::size_t(1));
    QCOMPARE(t.euler(), 0LL);
    QCOMPARE(t.genus(), std::optional<long long>(1));
    const Topology both = of(meshes::together(meshes::moebius(20), meshes::tetrahedron()));
    QVERIFY(both.mixed && !both.orientable && !both.genus());
}

void TopologyTest::flippedTrianglesAreOpposedNotOneSided() {
    Mesh m = meshes::torus(8, 12);
    std::swap(m.triangles[30][0], m.triangles[30][1]);
    const Topology t = of(m);
    QCOMPARE(t.opposedEdges, std::size_t(3));
    QVERIFY(t.orientable && t.manifold());
    QCOMPARE(t.boundaryLoops, std::size_t(0));
}

void TopologyTest::tetrahedraSharingAnEdgeAreNotManifold() {
    Mesh m = meshes::together(meshes::tetrahedron(), meshes::tetrahedron({5, 0, 0}));
    m = meshes::joined(meshes::joined(m, 4, 0), 5, 1);
    const Topology t = of(m);
    QCOMPARE(t.nonManifoldEdges, std::size_t(1));
    QCOMPARE(t.nonManifoldVertices, std::size_t(2));
    QCOMPARE(t.components, std::size_t(1));
    QCOMPARE(t.unused, std::size_t(2));
    QVERIFY(!t.manifold() && !t.genus());
}

void TopologyTest::tetrahedraSharingAVertexAreNotManifold() {
    const Topology t =
        of(meshes::joined(meshes::together(meshes::tetrahedron(), meshes::tetrahedron({5, 0, 0})), 6, 2));
    QCOMPARE(t.nonManifoldEdges, std::size_t(0));
    QCOMPARE(t.nonManifoldVertices, std::size_t(1));
    QCOMPARE(t.components, std::size_t(1));
    QCOMPARE(t.euler(), 3LL);
}

void TopologyTest::loopsOfAPinchedVertexAreOneWalk() {
    Mesh m = meshes::torus(8, 12);
    // Two triangles that share the vertex 0 and no other.
    std::vector<Triangle> at;
    for (const Triangle& t : m.triangles)
        if (t[0] == 0 || t[1] == 0 || t[2] == 0)
            at.push_back(t);
    const auto apart = [&](const Triangle& a, const Triangle& b) {
        std::set<std::uint32_t> all(a.begin(), a.end());
        all.insert(b.begin(), b.end());
        return all.size() == 5;
    };
    const Triangle first = at.front();
    const auto second = std::find_if(at.begin(), at.end(), [&](const Triangle& t) { return apart(first, t); });
    QVERIFY(second != at.end());
    std::erase(m.triangles, first);
    std::erase(m.triangles, *second);
    const Topology t = of(m);
    QCOMPARE(t.boundaryEdges, std::size_t(6));
    QCOMPARE(t.nonManifoldVertices, std::size_t(1));
    // Each umbrella at the vertex leads from one hole to the other.
    QCOMPARE(t.boundaryLoops, std::size_t(1));
}

void TopologyTest::foldLoopsAreThoseWithFoldVertices() {
    Mesh m = meshes::torus(8, 12);
    const Triangle a = m.triangles.front(), b = m.triangles[100];
    std::erase(m.triangles, a);
    std::erase(m.triangles, b);
    m.kinds.assign(m.positions.size(), mesh::VertexKind::Inner);
    m.kinds[a[0]] = mesh::VertexKind::Limit;
    m.kinds[b[1]] = mesh::VertexKind::Fold;
    const Topology t = of(m);
    QCOMPARE(t.boundaryLoops, std::size_t(2));
    QCOMPARE(t.foldLoops, std::size_t(1));
}

void TopologyTest::improperTrianglesAndUnusedVerticesAreCounted() {
    Mesh m = meshes::tetrahedron();
    m.positions.push_back({9, 9, 9});
    m.triangles.push_back({1, 1, 2});
    const Topology t = of(m);
    QCOMPARE(t.unused, std::size_t(1));
    QCOMPARE(t.improper, std::size_t(1));
    QCOMPARE(t.faces, std::size_t(4));
    QVERIFY(t.manifold());
    const Topology nothing = of({});
    QCOMPARE(nothing.euler(), 0LL);
    QCOMPARE(nothing.components, std::size_t(0));
}

void TopologyTest::wrongNumbersAreRefused() {
    Mesh m = meshes::tetrahedron();
    m.triangles[0][0] = 4;
    QVERIFY_EXCEPTION_THROWN(of(m), std::out_of_range);
}

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Boundary loops by walking: from a directed boundary edge around its end vertex, triangle by triangle, to the next.
std::size_t loopsByWalking(const std::vector<Triangle>& triangles) {
    std::map<Edge, std::uint32_t> third; // directed edge -> opposite corner; orientation agrees everywhere
    for (const Triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            third[{t[k], t[(k + 1) % 3]}] = t[(k + 2) % 3];
    std::set<Edge> open;
    for (const auto& [edge, corner] : third)
        if (!third.contains({edge.second, edge.first}))
            open.insert(edge);
    std::size_t loops = 0;
    while (!open.empty()) {
        ++loops;
        Edge at = *open.begin();
        while (open.erase(at)) {
            Edge turned{at.second, third.at(at)}; // in the same triangle
            while (third.contains({turned.second, turned.first}))
                turned = {turned.first, third.at({turned.second, turned.first})};
            at = turned;
        }
    }
    return loops;
}

/// Vertices whose triangles do not all reach each other across edges at the vertex.
std::size_t pinchesByFlooding(const std::vector<Triangle>& triangles, std::uint32_t vertices) {
    std::size_t out = 0;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        std::vector<std::set<std::uint32_t>> around; // the other two corners
        for (const Triangle& t : triangles)
            if (std::find(t.begin(), t.end(), v) != t.end()) {
                std::set<std::uint32_t> others(t.begin(), t.end());
                others.erase(v);
                around.push_back(others);
            }
        for (bool merged = true; merged;) {
            merged = false;
            for (std::size_t i = 0; i < around.size(); ++i)
                for (std::size_t j = i + 1; j < around.size(); ++j)
                    if (std::any_of(around[i].begin(), around[i].end(),
                                    [&](auto w) { return around[j].contains(w); })) {
                        around[i].insert(around[j].begin(), around[j].end());
                        around.erase(around.begin() + static_cast<std::ptrdiff_t>(j--));
                        merged = true;
                    }
        }
        out += around.size() > 1;
    }
    return out;
}

} // namespace

void TopologyTest::randomHolesAgreeWithBruteForce() {
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int round = 0; round < test::effort(60); ++round) {
        Mesh m = round % 2 == 0 ? meshes::torus(5, 7) : meshes::sphere(2);
        const std::size_t gone = 1 + random.below(m.triangles.size() - 1);
        for (std::size_t i = 0; i < gone; ++i)
            m.triangles.erase(m.triangles.begin() + static_cast<std::ptrdiff_t>(random.below(m.triangles.size())));
        const Topology t = of(m);
        std::set<std::uint32_t> vertices;
        std::set<Edge> edges;
        for (const Triangle& f : m.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                vertices.insert(f[k]);
                edges.insert(std::minmax(f[k], f[(k + 1) % 3]));
            }
        const QByteArray where = QByteArray("seed ") + QByteArray::number(seed) + " round " + QByteArray::number(round);
        const auto euler =
            static_cast<long long>(vertices.size() + m.triangles.size()) - static_cast<long long>(edges.size());
        QVERIFY2(t.euler() == euler, where);
        QVERIFY2(t.orientable && t.opposedEdges == 0 && t.nonManifoldEdges == 0, where);
        QVERIFY2(t.boundaryLoops == loopsByWalking(m.triangles), where);
        const auto count = static_cast<std::uint32_t>(m.positions.size());
        QVERIFY2(t.nonManifoldVertices == pinchesByFlooding(m.triangles, count), where);
    }
}

static const test::Registered<TopologyTest> registered;
#include "topology_test.moc"
