// Restricted Delaunay triangulation: what it promises of angles and distances, and what is known of shapes that have a
// name.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/mesh/check/check.h"
#include "core/mesh/delaunay/delaunay.h"
#include "core/mesh/delaunay/delaunay_finish.h"
#include "core/mesh/finish/make_manifold.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"
#include "mesh/meshes.h"
#include "mesh/models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"
#include "surface/scans.h"

#include <QTest>

using base::Vec3d, mesh::DelaunayOptions, mesh::DelaunayReport, mesh::Mesh;

class DelaunayTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shapesKeepTheirTopology_data();
    void shapesKeepTheirTopology();
    void ballsAreEmpty();
    void sizesFollowCurvature();
    void rimsAreKept();
    void everyPieceIsFound();
    void demandsHoldAtFolds();
    void demandsHoldWhateverTheyAre_data();
    void demandsHoldWhateverTheyAre();
    void demandsHoldOnScans_data();
    void demandsHoldOnScans();
    void foldsCloseOnRequest();
    void coloursAreBlended();
    void threadsDoNotShow();
    void excessTrianglesAreTakenAway();
    void cancellingStops();
    void curvesAreRefused();
    void sizesWithoutEndAreRefused();
};

namespace {

constexpr double degree = meshes::pi / 180;

double spacingOf(const surface::Surface& surface) {
    return double(surface.tree().maxSupport()) / 3.5;
}

Mesh meshOf(const surface::Surface& surface, const DelaunayOptions& options = {}) {
    DelaunayReport report;
    return mesh::restrictedDelaunay(surface, options, report);
}

mesh::Topology topologyOf(const Mesh& m) {
    return mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
}

surface::Surface shape(const std::string& name) {
    // Fewer leave the knot so thick in supports that its sheets meet.
    const std::size_t count = name == "knot" ? 4000 : static_cast<std::size_t>(test::effort(4000));
    if (name == "half sphere")
        return models::halfSphere(count / 2);
    if (name == "cube")
        return models::cube(14);
    if (name == "double torus")
        return models::doubleTorus(0.12);
    if (name == "touching spheres")
        return models::touchingSpheres(600, shapes::bounded(0.6f)); // open: the mesh ends where they touch
    if (name == "plane")
        return shapes::surfaceOf(shapes::plane(15, 0.1, 0.35), shapes::bounded(0.3f));
    return models::sampled(name.c_str(), name == "sphere" ? 1500 : count);
}

} // namespace

void DelaunayTest::shapesKeepTheirTopology_data() {
    QTest::addColumn<int>("euler");
    QTest::addColumn<int>("loops");
    QTest::addColumn<bool>("orientable");
    QTest::addRow("sphere") << 2 << 0 << true;
    QTest::addRow("torus") << 0 << 0 << true;
    QTest::addRow("knot") << 0 << 0 << true;
    QTest::addRow("double torus") << -2 << 0 << true;
    QTest::addRow("cube") << 2 << 0 << true;
    QTest::addRow("moebius") << 0 << 1 << false;
    QTest::addRow("half sphere") << 1 << 1 << true;
    QTest::addRow("plane") << 1 << 1 << true;
}

void DelaunayTest::shapesKeepTheirTopology() {
    QFETCH(int, euler);
    QFETCH(int, loops);
    QFETCH(bool, orientable);
    const surface::Surface surface = shape(QTest::currentDataTag());
    DelaunayOptions options;
    options.size = 1.5 * spacingOf(surface);
    options.distance = 0.2 * spacingOf(surface);
    DelaunayReport found;
    const Mesh mesh = mesh::restrictedDelaunay(surface, options, found);
    const mesh::Report report = mesh::check(mesh, surface);
    QVERIFY(report.topology.manifold());
    QCOMPARE(report.topology.components, std::size_t(1));
    QCOMPARE(report.topology.euler(), euler);
    QCOMPARE(report.topology.boundaryLoops, std::size_t(loops));
    QCOMPARE(report.topology.foldLoops, std::size_t(0));
    QCOMPARE(report.topology.orientable, orientable);
    QCOMPARE(report.topology.opposedEdges == 0, orientable);
    QCOMPARE(report.topology.unused, std::size_t(0));
    QVERIFY2(report.shape.leastAngle >= 25 * degree, QByteArray::number(report.shape.leastAngle / degree));
    QVERIFY2(report.faces.max <= options.distance, QByteArray::number(report.faces.max / options.distance));
    QVERIFY2(report.vertices.max <= 1e-6 * spacingOf(surface), QByteArray::number(report.vertices.max));
    QCOMPARE(report.faces.lost + report.vertices.lost + report.selfIntersections, std::size_t(0));
    QCOMPARE(found.unrefined + found.removed, std::size_t(0));
    // Normals are gradients and agree with the triangles.
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3d across =
            cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
        for (const std::uint32_t v : t)
            QVERIFY(!orientable || dot(across, base::cast<double>(mesh.normals[v])) > 0);
    }
}

/// The definition by brute force: the surface meets the axis of every triangle in the centre of a ball with no vertex
/// inside.
void DelaunayTest::ballsAreEmpty() {
    const surface::Surface surface = models::sampled("torus", 2500);
    const double s = spacingOf(surface);
    DelaunayOptions options;
    options.size = 2 * s;
    const Mesh mesh = meshOf(surface, options);
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3d a = mesh.positions[t[0]], u = mesh.positions[t[1]] - a, v = mesh.positions[t[2]] - a;
        const Vec3d across = cross(u, v);
        const Vec3d middle =
            a + (cross(across, u) * lengthSq(v) + cross(v, across) * lengthSq(u)) / (2 * lengthSq(across));
        const Vec3d along = base::normalized(across);
        std::optional<Vec3d> centre; // where the axis meets the surface next to the middle
        for (const auto& hit : intersectAllReference(surface, {middle - along * s, along}))
            if (!centre || distance(hit.position, middle) < distance(*centre, middle))
                centre = hit.position;
        QVERIFY(centre && distance(*centre, middle) < s);
        const double radius = distance(*centre, a);
        QVERIFY2(radius <= options.size * (1 + 1e-5), QByteArray::number(radius / options.size));
        for (const Vec3d& p : mesh.positions)
            QVERIFY(distance(p, *centre) >= radius * (1 - 1e-5));
    }
}

void DelaunayTest::sizesFollowCurvature() {
    const surface::Surface surface = models::cube(14);
    const double s = 2.0 / 14;
    DelaunayOptions options;
    options.adaptive = 0.05 * s;
    const Mesh mesh = meshOf(surface, options);
    double flat = 0, round = 0; // longest edges amid the sides of the cube, and at its edges
    for (const mesh::Triangle& t : mesh.triangles) {
        const Vec3d a = mesh.positions[t[0]], b = mesh.positions[t[1]];
        const auto inside = [](const Vec3d& p) {
            double x[3] = {std::abs(p.x), std::abs(p.y), std::abs(p.z)};
            std::sort(x, x + 3);
            return 1 - x[1];
        };
        if (std::min(inside(a), inside(b)) > 0.3)
            flat = std::max(flat, distance(a, b));
        else if (std::max(inside(a), inside(b)) < 0.05)
            round = std::max(round, distance(a, b));
    }
    const mesh::Report report = mesh::check(mesh, surface);
    QVERIFY2(report.faces.max <= options.adaptive, QByteArray::number(report.faces.max / options.adaptive));
    QCOMPARE(report.topology.euler(), 2LL);
    QVERIFY2(flat > 2 * round, QByteArray::number(flat / s) + ' ' + QByteArray::number(round / s));
    DelaunayOptions even;
    even.distance = options.adaptive;
    even.size = 0.5 * s;
    QVERIFY(mesh.triangles.size() < meshOf(surface, even).triangles.size());
}

/// Every edge of the boundary has both ends on the boundary curve, to rounding, and is short.
void DelaunayTest::rimsAreKept() {
    const surface::Surface surface = models::halfSphere(3000);
    const double s = spacingOf(surface);
    DelaunayOptions options;
    options.size = 1.5 * s;
    const Mesh mesh = meshOf(surface, options);
    std::size_t limits = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        QVERIFY(mesh.kinds[v] != mesh::VertexKind::Fold);
        if (mesh.kinds[v] != mesh::VertexKind::Limit)
            continue;
        ++limits;
        const surface::Evaluationd e = surface.evaluateReference(mesh.positions[v]);
        QVERIFY(std::abs(e.offCentre - double(surface.definition().boundaryLimit) * e.unit) < 1e-9);
    }
    const auto curves = findBoundaryCurves(surface);
    QCOMPARE(curves.size(), std::size_t(1));
    QVERIFY(double(limits) > curves[0].length() / (2 * options.size));
}

void DelaunayTest::everyPieceIsFound() {
    if (test::sanitized)
        QSKIP("ten seconds under a sanitizer");
    surfel::SurfelList all;
    all.layout = shapes::layout(true, true);
    for (int i = 0; i < 3; ++i) {
        const double radius = 1 / std::pow(3.0, i);
        surfel::SurfelList one = shapes::sphere(300, radius, 3.5 * shapes::sphereSpacing(300, radius));
        for (surfel::Surfel& s : one.items) {
            s.position.x += static_cast<float>(3 * i);
            all.items.push_back(s);
        }
    }
    const surface::Surface surface = shapes::surfaceOf(all);
    // A size that the smaller ones do not reach: their initial points alone are no triangles.
    DelaunayOptions options;
    options.size = 0.2;
    options.distance = 0.01;
    DelaunayReport report;
    const mesh::Topology t = topologyOf(mesh::restrictedDelaunay(surface, options, report));
    QCOMPARE(t.components, std::size_t(3));
    QCOMPARE(t.euler(), 6LL);
    QCOMPARE(report.unrefined, std::size_t(0));
    // Spheres that touch are whole, together or apart.
    const mesh::Topology both = topologyOf(meshOf(shape("touching spheres")));
    QVERIFY(both.manifold());
    QVERIFY(both.components == 1 || both.components == 2);
}

static void verifyDemands(const surface::Surface& surface, double unit, double size = 1, double distance = 0.1) {
    DelaunayOptions options;
    options.size = size * unit;
    options.distance = distance * unit;
    DelaunayReport report;
    const Mesh mesh = mesh::restrictedDelaunay(surface, options, report);
    const mesh::Report found = mesh::check(mesh, surface);
    QVERIFY(!mesh.triangles.empty());
    QVERIFY(found.topology.manifold());
    // a closed surface keeps the few that break a demand
    const double angle = report.missed > 0 ? found.shape.hundredthAngle : found.shape.leastAngle;
    const double far = report.missed > 0 ? found.faces.hundredth : found.faces.max;
    QVERIFY2(report.missed == 0 || found.topology.boundaryEdges == 0, QByteArray::number(report.missed));
    QVERIFY2(angle >= 25 * degree, QByteArray::number(angle / degree));
    QVERIFY2(far <= options.distance && found.faces.lost == 0, QByteArray::number(far / unit));
    QVERIFY2(found.vertices.max <= 0.01 * unit && found.vertices.lost == 0,
             QByteArray::number(found.vertices.max / unit));
    QCOMPARE(found.selfIntersections, std::size_t(0));
    const std::size_t broken = report.unrefined + report.missed;
    QVERIFY2(broken <= mesh.triangles.size() / 50, QByteArray::number(broken));
}

/// Spheres that touch: f jumps between them, and triangles in space would have to be infinitely small.
void DelaunayTest::demandsHoldAtFolds() {
    verifyDemands(shape("touching spheres"), shapes::sphereSpacing(600, 1));
}

void DelaunayTest::demandsHoldWhateverTheyAre_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"cube", "half sphere", "moebius", "touching spheres"})
        QTest::addRow("%s", name) << QString(name);
}

/// Coarse triangles that must become fine at edges, fine ones with room to spare.
void DelaunayTest::demandsHoldWhateverTheyAre() {
    QFETCH(QString, name);
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    const surface::Surface surface = shape(name.toStdString());
    const double unit = double(process::typicalSpacing(surface.tree()));
    for (int i = 0; i < test::effort(6); ++i) {
        const double size = random.uniform(0.5, 5), near = random.uniform(0.03, 0.3);
        verifyDemands(surface, unit, size, near);
        if (QTest::currentTestFailed())
            QFAIL(qPrintable(QString("seed %1: size %2, distance %3").arg(seed).arg(size).arg(near)));
    }
}

void DelaunayTest::demandsHoldOnScans_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("size");
    QTest::addRow("bunny") << "bunny/bun_zipper.ply" << 3.0;
    QTest::addRow("dragon") << "dragon_res2.ply" << 1.0;
}

void DelaunayTest::demandsHoldOnScans() {
    if (test::sanitized)
        QSKIP("minutes under a sanitizer");
    QFETCH(QString, file);
    surfel::SurfelList points;
    if (const char* why = scans::load(file, points))
        QSKIP(why);
    const surface::Surface prepared = process::prepare(std::move(points), {});
    surface::SurfaceDefinition open = prepared.definition(); // what is closed may keep triangles that break a demand
    open.boundaryLimit = std::min(open.boundaryLimit, 0.6f);
    const surface::Surface surface{prepared.tree(), open};
    QFETCH(double, size);
    verifyDemands(surface, double(process::typicalSpacing(surface.tree())), size);
}

void DelaunayTest::foldsCloseOnRequest() {
    const surface::Surface surface = shape("touching spheres");
    DelaunayOptions options;
    DelaunayReport report;
    const mesh::Topology open = topologyOf(mesh::restrictedDelaunay(surface, options, report));
    options.finishing.closeFolds = true;
    const mesh::Topology closed = topologyOf(mesh::restrictedDelaunay(surface, options, report));
    QVERIFY(open.foldLoops > 0 && closed.manifold());
    QVERIFY(report.foldsClosed > 0);
    QCOMPARE(closed.boundaryLoops + report.foldsClosed, open.boundaryLoops);
}

void DelaunayTest::coloursAreBlended() {
    surfel::SurfelList list = shapes::sphere(1000, 1, 3.5 * shapes::sphereSpacing(1000, 1));
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = layout->masks = true;
    list.layout = layout;
    for (surfel::Surfel& s : list.items) {
        s.colour = surfel::rgba(static_cast<unsigned>(127 + 120 * s.position.z), 10, 20, 30);
        s.mask = 0.5f + 0.4f * s.position.x;
    }
    const Mesh mesh = meshOf(shapes::surfaceOf(list));
    QCOMPARE(mesh.colours.size(), mesh.positions.size());
    QCOMPARE(mesh.masks.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        QVERIFY(std::abs(double(mesh.colours[v] & 0xff) - (127 + 120 * mesh.positions[v].z)) < 8);
        QCOMPARE(mesh.colours[v] >> 8, surfel::rgba(0, 10, 20, 30) >> 8);
        QVERIFY(std::abs(double(mesh.masks[v]) - (0.5 + 0.4 * mesh.positions[v].x)) < 0.03);
    }
}

void DelaunayTest::threadsDoNotShow() {
    const surface::Surface surface = models::halfSphere(1500);
    const auto work = [&] { return meshOf(surface); };
    const Mesh one = test::onThreads(1, work), all = work();
    QVERIFY(one.positions == all.positions && one.triangles == all.triangles && one.normals == all.normals);
}

void DelaunayTest::excessTrianglesAreTakenAway() {
    Mesh m = meshes::together(meshes::tetrahedron(), meshes::tetrahedron({5, 0, 0}));
    m = meshes::joined(meshes::joined(m, 4, 0), 5, 1);
    m.kinds.assign(m.positions.size(), mesh::VertexKind::Inner);
    const std::size_t removed = mesh::makeManifold(m);
    QCOMPARE(removed, std::size_t(2));
    QVERIFY(topologyOf(m).manifold());
    Mesh pinched = meshes::joined(meshes::together(meshes::tetrahedron(), meshes::tetrahedron({5, 0, 0})), 6, 2);
    pinched.kinds.assign(pinched.positions.size(), mesh::VertexKind::Inner);
    QCOMPARE(mesh::makeManifold(pinched), std::size_t(0));
    QCOMPARE(topologyOf(pinched).components, std::size_t(2));
    QCOMPARE(topologyOf(pinched).euler(), 4LL);
}

void DelaunayTest::cancellingStops() {
    const std::atomic<bool> stop{true};
    base::Progress progress;
    progress.cancel = &stop;
    DelaunayReport report;
    QVERIFY_EXCEPTION_THROWN(mesh::restrictedDelaunay(shape("sphere"), {}, report, progress), base::Cancelled);
}

void DelaunayTest::curvesAreRefused() {
    DelaunayReport report;
    QVERIFY_EXCEPTION_THROWN(mesh::restrictedDelaunay({}, {}, report), base::Error);
}

void DelaunayTest::sizesWithoutEndAreRefused() {
    const surface::Surface surface = shape("sphere");
    DelaunayReport report;
    DelaunayOptions small, near;
    small.size = 1e-9;
    near.distance = 1e-15;
    QVERIFY_EXCEPTION_THROWN(mesh::restrictedDelaunay(surface, small, report), base::Error);
    QVERIFY_EXCEPTION_THROWN(mesh::restrictedDelaunay(surface, near, report), base::Error);
}

static const test::Registered<DelaunayTest> registered;
#include "delaunay_test.moc"
