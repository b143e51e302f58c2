// Delaunay triangulations of closed surfaces: whatever the points and the sizes, no boundary and no cuts; the right
// topology where the points can tell it.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/check/check.h"
#include "core/mesh/check/self_intersections.h"
#include "core/mesh/delaunay/cut_guard.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/process/estimation/spacing_sample.h"
#include "mesh/meshes.h"
#include "mesh/models.h"
#include "mesh/solid_rows.h"
#include "support/registry.h"
#include "support/thread_counts.h"
#include "surface/scans.h"

#include <QTest>

using base::Vec3d, mesh::DelaunayOptions, mesh::DelaunayReport, mesh::Mesh, mesh::Topology, mesh::Triangle;

class ClosedDelaunayTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedInClosedOut_data();
    void closedInClosedOut();
    void evenSurfacesMeetEveryDemand();
    void closedScansStayClosed();
    void gapsAreClosedAsCubesClose();
    void triangulationsThatTouchInSpaceStayApart();
    void guardsSeeEveryCut();
    void guardsForgetFacesThatWent();
    void threadsDoNotShow();
    void cancellingStops();
};

using solids::hows, solids::isClosed, solids::Row, solids::spacing, solids::topologyOf;

namespace {

std::vector<Row> rowsOf(base::Random& random) {
    const auto wedge = [](double degrees) {
        return solids::Solid{{solids::wedge(degrees * shapes::pi / 180, 0.8, 0.6)}, {}, 1, 0};
    };
    std::vector<Row> out;
    out.push_back({"balls", solids::balls(random), true});
    out.push_back({"fins of 0.6", solids::comb(0.6 * spacing, 2 * spacing), false});
    out.push_back({"fins of 1.5", solids::comb(1.5 * spacing, 2 * spacing), false});
    out.push_back({"gaps of 1", solids::comb(2 * spacing, spacing), false});
    out.push_back({"shell of 1", solids::shell(spacing), false});
    out.push_back({"shell of 3", solids::shell(3 * spacing), true});
    out.push_back({"slabs of 1", solids::crossedSlabs(spacing), false});
    out.push_back({"wedge of 10", wedge(10), false});
    out.push_back({"wedge of 20", wedge(20), false});
    out.push_back({"wedge of 30", wedge(30), true});
    out.push_back({"wedge of 40", wedge(40), true});
    out.push_back({"wedge of 75", wedge(75), true});
    out.push_back({"drilled", solids::drilled(0.15), true});
    out.push_back({"tori", solids::tori(), true});
    return out;
}

Mesh meshOf(const surface::Surface& surface, const DelaunayOptions& options = {}) {
    DelaunayReport report;
    return mesh::restrictedDelaunay(surface, options, report);
}

} // namespace

void ClosedDelaunayTest::closedInClosedOut_data() {
    base::Random random(test::seed());
    solids::addRows(rowsOf(random), [](std::size_t i, std::size_t k) {
        return test::effort(5) == 5 ? k % 5 == i % 5 || k % 5 == (i + 2) % 5 : i < 2 && k == i;
    });
}

/// At the default sizes, or at 0.5, 1 or 2 spacings, or by curvature: one of them for each, and another with each seed.
void ClosedDelaunayTest::closedInClosedOut() {
    QFETCH(int, row);
    QFETCH(int, how);
    base::Random random(test::seed());
    const Row made = rowsOf(random)[std::size_t(row)];
    const surface::Surface surface = solids::surfaceOf(solids::sampled(made.solid, hows[how].sampling, random));
    DelaunayOptions options;
    const int way = int((std::uint64_t(row + how) + test::seed()) % 5);
    if (way == 4)
        options.adaptive = 0.1 * spacing;
    else
        options.size = std::array{0.0, 0.5, 1.0, 2.0}[std::size_t(way)] * spacing;
    const auto where = "seed " + QByteArray::number(test::seed()) + " size " + QByteArray::number(options.size) +
                       " adaptive " + QByteArray::number(options.adaptive) + ' ';
    Mesh m;
    try {
        m = meshOf(surface, options);
    } catch (const base::Error&) { // what is thinner than a cell may lie between its nodes
        QVERIFY2(!made.resolved, where);
        return;
    }
    const Topology t = topologyOf(m);
    QVERIFY2(isClosed(t), where + QByteArray::number(t.boundaryLoops));
    const std::size_t cuts = mesh::selfIntersections(m).size();
    QVERIFY2(cuts == 0, where + QByteArray::number(cuts));
    if (!made.resolved || !hows[how].kind)
        return;
    QVERIFY2(t.components == made.solid.pieces, where + QByteArray::number(t.components));
    QVERIFY2(t.genus() == made.solid.genus, where);
}

/// Nothing is held or missed where no sheets are near, and nothing left open where they are.
void ClosedDelaunayTest::evenSurfacesMeetEveryDemand() {
    const surface::Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing));
    DelaunayOptions options;
    options.size = 1.5 * spacing;
    options.distance = 0.05 * spacing;
    DelaunayReport report;
    const Mesh m = mesh::restrictedDelaunay(surface, options, report);
    const mesh::Report found = mesh::check(m, surface);
    QCOMPARE(report.missed, std::size_t(0));
    QVERIFY(isClosed(found.topology));
    QCOMPARE(found.topology.genus(), std::optional<long long>(1));
    QVERIFY(found.shape.leastAngle >= 25 * shapes::pi / 180);
    QVERIFY2(found.faces.max <= options.distance, QByteArray::number(found.faces.max / options.distance));
    QVERIFY2(found.vertices.max <= 1e-6 * spacing, QByteArray::number(found.vertices.max / spacing));
}

/// A statue without samples below its belly and feet; away from there every demand holds.
void ClosedDelaunayTest::closedScansStayClosed() {
    if (test::effort(10) < 10)
        QSKIP("minutes under a sanitizer");
    surfel::SurfelList points;
    if (const char* why = scans::load("ankylosaurus.ply", points))
        QSKIP(why);
    surface::SurfaceDefinition closed;
    closed.boundary = surface::Boundary::None;
    const surface::Surface surface = process::prepare(std::move(points), {.definition = closed});
    const double s = double(process::typicalSpacing(surface.tree()));
    DelaunayReport report;
    const Mesh m = mesh::restrictedDelaunay(surface, {}, report);
    const mesh::Report found = mesh::check(m, surface);
    QVERIFY(isClosed(found.topology));
    QCOMPARE(found.topology.components, std::size_t(1));
    QCOMPARE(found.selfIntersections, std::size_t(0));
    QVERIFY2(report.missed < m.triangles.size() / 5, QByteArray::number(report.missed));
    QVERIFY2(found.faces.median <= 0.1 * s, QByteArray::number(found.faces.median / s));
    QVERIFY(found.shape.hundredthAngle >= 25 * shapes::pi / 180);
}

/// A sphere whose points leave out a cap as wide as several supports.
void ClosedDelaunayTest::gapsAreClosedAsCubesClose() {
    const surfel::SurfelList all = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    surfel::SurfelList some;
    some.layout = all.layout;
    for (const surfel::Surfel& s : all.items)
        if (s.position.z < 0.85f)
            some.items.push_back(s);
    DelaunayReport report;
    const surface::Surface surface = shapes::surfaceOf(some);
    const Mesh m = mesh::restrictedDelaunay(surface, {}, report);
    QVERIFY(isClosed(topologyOf(m)));
    QCOMPARE(topologyOf(m).components, std::size_t(1));
    QCOMPARE(topologyOf(m).genus(), std::optional<long long>(0));
    QVERIFY(mesh::selfIntersections(m).empty());
    QVERIFY(report.missed > 10 && report.missed < m.triangles.size() / 5);
    double highest = 0;
    for (const Vec3d& p : m.positions) {
        QVERIFY(length(p) < 1.15 && length(p) > 0.7);
        highest = std::max(highest, p.z);
    }
    QVERIFY(highest > 0.85);
}

/// Spheres that touch: one piece or two, with nothing in between left open.
void ClosedDelaunayTest::triangulationsThatTouchInSpaceStayApart() {
    const surface::Surface surface = models::touchingSpheres(600);
    const double s = shapes::sphereSpacing(600, 1);
    for (const double size : {0.5, 1.0, 2.0}) {
        DelaunayOptions options;
        options.size = size * s;
        const Mesh m = meshOf(surface, options);
        const Topology t = topologyOf(m);
        QVERIFY(isClosed(t));
        QVERIFY(t.components == 1 || t.components == 2);
        QCOMPARE(t.genus(), std::optional<long long>(0));
        QVERIFY(mesh::selfIntersections(m).empty());
    }
}

namespace {

Mesh torusWithNormals() {
    Mesh out = meshes::torus(12, 24);
    out.normals.assign(out.positions.size(), {0, 0, 1});
    out.kinds.assign(out.positions.size(), mesh::VertexKind::Inner);
    return out;
}

/// By all pairs: does a face from number `first` on, or one without an area, cut another?
bool cutsFrom(const Mesh& m, std::size_t first) {
    for (std::size_t f = first; f < m.triangles.size(); ++f)
        if (mesh::isFlat(m.positions, m.triangles[f]))
            return true;
    const auto all = mesh::selfIntersections(m);
    return std::any_of(all.begin(), all.end(), [&](const auto& pair) { return pair.second >= first; });
}

} // namespace

/// Faces of a torus split by points anywhere near: allowed exactly if what comes out has no cut.
void ClosedDelaunayTest::guardsSeeEveryCut() {
    const surface::Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, 0.2, 0.7));
    const Mesh plain = torusWithNormals();
    base::Random random(test::seed());
    int cuts = 0;
    constexpr int times = test::effort(300);
    for (int i = 0; i < times; ++i) {
        mesh::SurfaceTriangulation faces(surface, plain);
        mesh::CutGuard guard(faces, random.uniform(0.05, 1));
        const auto face = static_cast<std::uint32_t>(random.below(plain.triangles.size()));
        const Triangle t = plain.triangles[face];
        const auto [a, b, c] = faces.cornersOf(t);
        const Vec3d x = i % 10 == 0 ? (a + b) * 0.5 : (a + b + c) / 3 + random.unitVector() * random.uniform(0, 0.8);
        const std::uint32_t v = faces.addVertex({x, {0, 0, 1}}, mesh::VertexKind::Inner);
        const std::array made{Triangle{t[0], t[1], v}, Triangle{t[1], t[2], v}, Triangle{t[2], t[0], v}};
        Mesh after = plain;
        after.positions.push_back(x);
        after.triangles.erase(after.triangles.begin() + face);
        after.triangles.insert(after.triangles.end(), made.begin(), made.end());
        const bool cut = cutsFrom(after, plain.triangles.size() - 1);
        cuts += cut ? 1 : 0;
        QVERIFY2(guard.allows(made, {&face, 1}) == !cut,
                 "seed " + QByteArray::number(test::seed()) + " try " + QByteArray::number(i));
    }
    QVERIFY(cuts > times / 10 && cuts < times * 9 / 10);
}

void ClosedDelaunayTest::guardsForgetFacesThatWent() {
    const surface::Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, 0.2, 0.7));
    mesh::SurfaceTriangulation faces(surface, torusWithNormals());
    mesh::CutGuard guard(faces, 0.3);
    const Triangle t = faces.corners(0);
    const auto [a, b, c] = faces.cornersOf(t);
    const Vec3d out = base::normalized((a + b + c) / 3 - base::normalized(Vec3d{a.x, a.y, 0}));
    const std::uint32_t v = faces.addVertex({(a + b + c) / 3 + out * 0.05, {0, 0, 1}}, mesh::VertexKind::Inner);
    const std::array made{Triangle{t[0], t[1], v}, Triangle{t[1], t[2], v}, Triangle{t[2], t[0], v}};
    const std::uint32_t instead = 0;
    QVERIFY(!guard.allows({&t, 1}, {})); // is there already
    QVERIFY(guard.allows({&t, 1}, {&instead, 1}));
    QVERIFY(guard.allows(made, {&instead, 1}));
    faces.splitFace(0, v);
    for (const std::uint32_t f : {0u, faces.faceCount() - 2, faces.faceCount() - 1})
        guard.update(f);
    QVERIFY(guard.allows({&t, 1}, {})); // a floor below a roof, with the same corners
    QVERIFY(!guard.allows(made, {}));
}

void ClosedDelaunayTest::threadsDoNotShow() {
    base::Random random(test::seed());
    const surface::Surface surface =
        solids::surfaceOf(solids::sampled(solids::comb(1.5 * spacing, 2 * spacing), {spacing, 1, 0.1, 5, {}}, random));
    const int threads = base::threadCount();
    std::vector<Mesh> made;
    for (const int count : test::comparedThreads({2})) {
        base::setThreadCount(count);
        made.push_back(meshOf(surface));
    }
    base::setThreadCount(threads);
    QVERIFY(made.front().positions == made.back().positions);
    QVERIFY(made.front().triangles == made.back().triangles);
    QVERIFY(made.front().normals == made.back().normals);
}

void ClosedDelaunayTest::cancellingStops() {
    const surface::Surface surface = shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing));
    int steps = 0;
    std::atomic<bool> cancel = false;
    DelaunayReport report;
    mesh::restrictedDelaunay(surface, {}, report, {[&](double, std::string_view) { ++steps; }, &cancel});
    for (const int at : {1, steps / 2, steps - 1}) {
        int count = 0;
        cancel = false;
        const base::Progress progress{[&](double, std::string_view) { cancel = ++count >= at; }, &cancel};
        QVERIFY_EXCEPTION_THROWN(mesh::restrictedDelaunay(surface, {}, report, progress), base::Cancelled);
    }
}

static const test::Registered<ClosedDelaunayTest> registered;
#include "closed_delaunay_test.moc"
