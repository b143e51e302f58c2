// Boundary loops and umbrellas of triangulations, manifold and not.
#include "core/mesh/connectivity/boundary_loops.h"

#include "core/base/random.h"
#include "core/mesh/connectivity/umbrellas.h"
#include "mesh/meshes.h"
#include "support/registry.h"

#include <QTest>
#include <set>

using mesh::BoundaryLoop, mesh::boundaryLoops, mesh::Side, mesh::Triangle, mesh::Triangulation;

class BoundaryLoopsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedMeshesHaveNone();
    void aMoebiusBandHasOneThatGoesTwiceAround();
    void loopsPartTheBoundary_data();
    void loopsPartTheBoundary();
    void threeTrianglesAtAnEdgeGoRound();
    void walksEndAtEdgesOfThreeTriangles();
    void umbrellasPartThePinchedVertex();
    void improperTrianglesHaveNoSides();
};

namespace {

std::size_t boundarySides(const Triangulation& t) {
    std::size_t out = 0;
    t.forSides([&](const Side& s) { out += t.onBoundary(s); });
    return out;
}

/// Each side of a loop shares the vertex that the walk leads over with the next; the last one with the first.
void verifyWalk(const Triangulation& t, const BoundaryLoop& loop) {
    std::uint32_t at = t.to(loop.front());
    for (std::size_t i = 1; i < loop.size(); ++i) {
        QVERIFY(t.onBoundary(loop[i]));
        QVERIFY(t.from(loop[i]) == at || t.to(loop[i]) == at);
        at = t.otherEnd(loop[i], at);
    }
    QCOMPARE(at, t.from(loop.front()));
}

const std::vector<Triangle> book{{0, 1, 2}, {0, 1, 3}, {1, 0, 4}}; // three pages at the edge 0 1

} // namespace

void BoundaryLoopsTest::closedMeshesHaveNone() {
    for (const mesh::Mesh& m : {meshes::tetrahedron(), meshes::torus(6, 9)}) {
        QVERIFY(boundaryLoops(Triangulation(m)).empty());
        const std::vector<bool> at = boundaryVertices(Triangulation(m));
        QVERIFY(std::find(at.begin(), at.end(), true) == at.end());
    }
}

void BoundaryLoopsTest::aMoebiusBandHasOneThatGoesTwiceAround() {
    const mesh::Mesh m = meshes::moebius(9);
    const Triangulation t(m);
    const std::vector<BoundaryLoop> loops = boundaryLoops(t);
    QCOMPARE(loops.size(), std::size_t(1));
    QCOMPARE(loops.front().size(), std::size_t(18));
    verifyWalk(t, loops.front());
}

void BoundaryLoopsTest::loopsPartTheBoundary_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"sphere", "torus", "moebius"})
        QTest::addRow("%s", name) << QString(name);
}

/// With holes and turned triangles anywhere.
void BoundaryLoopsTest::loopsPartTheBoundary() {
    QFETCH(QString, name);
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int i = 0; i < test::effort(20); ++i) {
        mesh::Mesh m = name == "sphere"  ? meshes::sphere(3)
                       : name == "torus" ? meshes::torus(9, 14)
                                         : meshes::moebius(40);
        std::erase_if(m.triangles, [&](const Triangle&) { return random.below(7) == 0; });
        for (Triangle& each : m.triangles)
            if (random.below(3) == 0)
                std::swap(each[0], each[1]);
        const Triangulation t(m);
        std::set<std::pair<std::uint32_t, int>> seen;
        for (const BoundaryLoop& loop : boundaryLoops(t)) {
            verifyWalk(t, loop);
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QString("seed %1").arg(seed)));
            for (const Side& s : loop)
                QVERIFY2(seen.emplace(s.face, s.k).second, QByteArray::number(seed));
        }
        QVERIFY2(seen.size() == boundarySides(t), QByteArray::number(seed));
    }
}

void BoundaryLoopsTest::threeTrianglesAtAnEdgeGoRound() {
    const Triangulation t(book, 5);
    const Side s{0, 2};
    QCOMPARE(t.facesAtEdge(s), std::size_t(3));
    QVERIFY(!t.onBoundary(s) && !t.across(s).exists());
    QCOMPARE(t.next(s).face, 1u);
    QCOMPARE(t.next(t.next(s)).face, 2u);
    QVERIFY(t.next(t.next(t.next(s))) == s);
    int edges = 0;
    t.forEdges([&](const Side&) { ++edges; });
    QCOMPARE(edges, 7);
}

/// A chain around each page; what hangs at the edge 0 1 by two triangles is walked from one end to the other.
void BoundaryLoopsTest::walksEndAtEdgesOfThreeTriangles() {
    const std::vector<BoundaryLoop> pages = boundaryLoops(Triangulation(book, 5));
    QCOMPARE(pages.size(), std::size_t(3));
    for (const BoundaryLoop& page : pages)
        QCOMPARE(page.size(), std::size_t(2));
    std::vector<Triangle> longer = book;
    longer.insert(longer.begin(), {0, 2, 5}); // beside the page 0 1 2: its chain starts in the middle
    const std::vector<BoundaryLoop> chains = boundaryLoops(Triangulation(longer, 6));
    QCOMPARE(chains.size(), std::size_t(3));
    QCOMPARE(chains.front().size(), std::size_t(3));
}

void BoundaryLoopsTest::umbrellasPartThePinchedVertex() {
    const mesh::Mesh m = meshes::joined(meshes::together(meshes::tetrahedron(), meshes::tetrahedron({5, 0, 0})), 6, 2);
    const std::vector<std::uint32_t> umbrellas = umbrellasOf(Triangulation(m));
    std::map<std::uint32_t, std::set<std::uint32_t>> at; // by vertex
    for (std::size_t corner = 0; corner < umbrellas.size(); ++corner)
        at[m.triangles[corner / 3][corner % 3]].insert(umbrellas[corner]);
    for (const auto& [vertex, some] : at)
        QCOMPARE(some.size(), std::size_t(vertex == 2 ? 2 : 1));
}

void BoundaryLoopsTest::improperTrianglesHaveNoSides() {
    const std::vector<Triangle> triangles{{0, 1, 1}, {0, 1, 2}};
    const Triangulation t(triangles, 3);
    QVERIFY(!t.alive(0) && t.alive(1));
    QCOMPARE(boundarySides(t), std::size_t(3));
    QCOMPARE(umbrellasOf(t).front(), Triangulation::none);
}

static const test::Registered<BoundaryLoopsTest> registered;
#include "boundary_loops_test.moc"
