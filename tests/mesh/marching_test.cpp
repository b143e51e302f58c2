// Marching cubes: manifold whatever comes, and what is known of shapes that have a name.
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/mesh/check/check.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/prepare.h"
#include "core/process/samples/samples.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "surface/bounded.h"
#include "surface/shapes.h"

#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::MarchingOptions, mesh::MarchingReport, mesh::Topology;

class MarchingTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void shapesKeepTheirTopology_data();
    void shapesKeepTheirTopology();
    void anyGridIsManifold();
    void verticesLieOnTheSphere();
    void rimsLieAtTheLimit();
    void trianglesAreWellShaped();
    void trianglesFaceOutwards();
    void foldsAreClosedOnRequest();
    void smallPiecesAreDroppedOnRequest();
    void coloursAndMasksAreThoseOfTheSurfels();
    void furtherAttributesAreBlendedAndLabelsKept();
    void threadsDoNotShow();
    void curvesAndNothingAreRefused();
};

namespace {

constexpr double spacing = 0.08;

/// As the sample comes, or without what it knows of orientation.
surface::Surface sampled(const char* id, std::size_t count) {
    return process::prepare(process::sample(id).make(count, 1), {});
}

surface::Surface halfSphere(bool oriented = true) {
    surfel::SurfelList all = shapes::sphere(4000, 1, 3.5 * shapes::sphereSpacing(4000, 1)), half;
    half.layout = shapes::layout(true, oriented);
    for (const surfel::Surfel& s : all.items)
        if (s.position.z > 0)
            half.items.push_back(s);
    return shapes::surfaceOf(half, shapes::bounded(0.3f));
}

MarchingOptions gridOf(double cell, base::Random& random) {
    MarchingOptions out;
    out.cell = cell;
    const Vec3d x = random.unitVector(), y = base::normalized(cross(x, random.unitVector())), z = cross(x, y);
    for (std::size_t i = 0; i < 3; ++i) {
        out.turned[0][i] = x[i];
        out.turned[1][i] = y[i];
        out.turned[2][i] = z[i];
    }
    out.shift = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
    return out;
}

Topology topologyOf(const Mesh& m) {
    return mesh::topologyOf(m.triangles, m.positions.size(), m.kinds);
}

} // namespace

void MarchingTest::shapesKeepTheirTopology_data() {
    QTest::addColumn<QString>("sample");
    QTest::addColumn<int>("euler");
    QTest::addColumn<int>("loops");
    QTest::addColumn<bool>("orientable");
    QTest::addRow("sphere") << "sphere" << 2 << 0 << true;
    QTest::addRow("torus") << "torus" << 0 << 0 << true;
    QTest::addRow("knot") << "knot" << 0 << 0 << true;
    QTest::addRow("moebius") << "moebius" << 0 << 1 << false;
    QTest::addRow("half sphere") << "" << 1 << 1 << true;
}

void MarchingTest::shapesKeepTheirTopology() {
    QFETCH(QString, sample);
    QFETCH(int, euler);
    QFETCH(int, loops);
    QFETCH(bool, orientable);
    const surface::Surface surface =
        sample.isEmpty() ? halfSphere() : sampled(sample.toStdString().c_str(), test::effort(4000));
    const double s = double(surface.tree().maxSupport()) / 3.5;
    for (const double cell : {0.7, 1.7}) {
        MarchingReport report;
        MarchingOptions options;
        options.cell = cell * s;
        const Topology topology = topologyOf(mesh::marchingCubes(surface, options, report));
        QVERIFY(topology.manifold());
        QCOMPARE(topology.components, std::size_t(1));
        QCOMPARE(topology.euler(), euler);
        QCOMPARE(topology.boundaryLoops, std::size_t(loops));
        QCOMPARE(topology.orientable, orientable);
        QCOMPARE(report.orientable(), orientable);
        QCOMPARE(topology.opposedEdges, report.parityConflicts);
        QCOMPARE(report.foldEnds, std::size_t(0));
        QCOMPARE(report.pieces, std::size_t(1));
        if (loops > 0)
            QVERIFY(report.limitEnds > 10);
    }
}

/// Whatever the points: noise, normals without a common sign, two sheets that touch.
void MarchingTest::anyGridIsManifold() {
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int i = 0; i < test::effort(8); ++i) {
        surfel::SurfelList list = shapes::sphere(700, 1, 3.5 * shapes::sphereSpacing(700, 1));
        const double s = shapes::sphereSpacing(700, 1);
        for (std::size_t k = 0, n = list.size(); k < n; ++k) {
            surfel::Surfel other = list.items[k];
            other.position.x += 2.0f + static_cast<float>(random.uniform(-0.3, 1)) * float(s);
            list.items.push_back(other);
        }
        list = shapes::jittered(list, random.uniform(0, 0.6) * s, seed + static_cast<unsigned long long>(i));
        list.layout = shapes::layout(true, i % 3 != 0);
        const surface::Surface surface =
            shapes::surfaceOf(list, i % 2 ? shapes::bounded(0.2f) : surface::SurfaceDefinition{});
        MarchingReport report;
        const Mesh m = mesh::marchingCubes(surface, gridOf(random.uniform(0.5, 2) * s, random), report);
        const Topology topology = topologyOf(m);
        const auto where = QByteArray("seed ") + QByteArray::number(seed) + " round " + QByteArray::number(i);
        QVERIFY2(topology.nonManifoldEdges == 0 && topology.nonManifoldVertices == 0 && topology.improper == 0, where);
        QVERIFY2(m.triangles.size() > 500, where);
    }
}

void MarchingTest::verticesLieOnTheSphere() {
    const std::size_t count = 4000;
    const double s = shapes::sphereSpacing(count, 1);
    const surface::Surface surface = shapes::surfaceOf(shapes::sphere(count, 1, 3.5 * s));
    for (const double cell : {0.5, 1.0, 2.0}) {
        if (test::sanitized && cell < 1) // half a minute there
            continue;
        MarchingReport report;
        MarchingOptions options;
        options.cell = cell * s;
        const Mesh m = mesh::marchingCubes(surface, options, report);
        const mesh::Deviation vertices = mesh::vertexDeviation(m, surface);
        QVERIFY2(vertices.max < 1e-4 * s && vertices.lost == 0, QByteArray::number(vertices.max / s));
        // of a cube's diagonal on a sphere of radius 1
        const double sagitta = 3 * options.cell * options.cell / 8;
        const mesh::Deviation faces = mesh::faceDeviation(m, surface);
        QVERIFY2(faces.max < sagitta && faces.lost == 0, QByteArray::number(faces.max / sagitta));
        for (std::size_t v = 0; v < m.positions.size(); ++v)
            QVERIFY(dot(base::cast<double>(m.normals[v]), base::normalized(m.positions[v])) > 0.9999);
    }
}

/// In both kinds of frames.
void MarchingTest::rimsLieAtTheLimit() {
    for (const bool oriented : {true, false}) {
        const surface::Surface surface = halfSphere(oriented);
        for (const double cell : {0.5, 1.0, 2.0}) {
            MarchingReport report;
            MarchingOptions options;
            options.cell = cell * double(surface.tree().maxSupport()) / 3.5;
            const Mesh m = mesh::marchingCubes(surface, options, report);
            std::size_t boundary = 0, off = 0;
            for (std::size_t v = 0; v < m.positions.size(); ++v) {
                if (m.kinds[v] == mesh::VertexKind::Inner)
                    continue;
                const surface::Evaluationd at = surface.evaluateReference(m.positions[v]);
                ++boundary;
                off += std::abs(at.offCentre / at.unit - 0.3) < 1e-3 ? 0 : 1;
            }
            QCOMPARE(boundary, report.limitEnds);
            QVERIFY2(200 * off <= boundary, QByteArray::number(off) + " of " + QByteArray::number(boundary));
        }
    }
}

/// And relaxing changes no connection.
void MarchingTest::trianglesAreWellShaped() {
    for (const char* id : {"knot", "moebius"}) {
        const surface::Surface surface = sampled(id, test::effort(4000));
        MarchingOptions options;
        MarchingReport report;
        const Mesh shaped = mesh::marchingCubes(surface, options, report);
        options.relax = false;
        const Mesh raw = mesh::marchingCubes(surface, options, report);
        const double degree = shapes::pi / 180;
        QVERIFY2(mesh::shapeOf(shaped).hundredthAngle > 10 * degree,
                 QByteArray::number(mesh::shapeOf(shaped).hundredthAngle / degree));
        QVERIFY(mesh::shapeOf(raw).hundredthAngle < 5 * degree);
        QCOMPARE(shaped.triangles.size(), raw.triangles.size());
        QCOMPARE(topologyOf(shaped).boundaryEdges, topologyOf(raw).boundaryEdges);
    }
}

void MarchingTest::trianglesFaceOutwards() {
    surfel::SurfelList list = shapes::torus(1, 0.4, spacing, 3.5 * spacing);
    for (const bool oriented : {true, false}) {
        list.layout = shapes::layout(true, oriented);
        MarchingReport report;
        const Mesh m = mesh::marchingCubes(shapes::surfaceOf(list), {}, report);
        double volume = 0;
        for (const mesh::Triangle& t : m.triangles)
            volume += dot(m.positions[t[0]], cross(m.positions[t[1]], m.positions[t[2]])) / 6;
        const double exact = 2 * shapes::pi * shapes::pi * 0.16;
        QVERIFY2(std::abs(volume / exact - 1) < 0.02, QByteArray::number(volume / exact));
        QCOMPARE(report.parityConflicts, std::size_t(0));
    }
}

/// Two spheres that touch: the definition ends around the place where they do.
void MarchingTest::foldsAreClosedOnRequest() {
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    for (std::size_t k = 0, n = list.size(); k < n; ++k) {
        surfel::Surfel other = list.items[k];
        other.position.x += 2;
        list.items.push_back(other);
    }
    const surface::Surface surface = shapes::surfaceOf(list, shapes::bounded(10)); // closed ones have no folds
    MarchingReport open, closed;
    MarchingOptions options;
    const Mesh before = mesh::marchingCubes(surface, options, open);
    options.finishing.closeFolds = true;
    const Mesh after = mesh::marchingCubes(surface, options, closed);
    QVERIFY(topologyOf(after).manifold());
    QCOMPARE(topologyOf(before).boundaryLoops + open.foldsClosed, topologyOf(after).boundaryLoops + closed.foldsClosed);
    QVERIFY(closed.foldsClosed > open.foldsClosed);
    QVERIFY(after.triangles.size() > before.triangles.size());
    QCOMPARE(topologyOf(after).opposedEdges, std::size_t(0));
}

void MarchingTest::smallPiecesAreDroppedOnRequest() {
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    const surfel::SurfelList small = shapes::sphere(3000, 0.05, 3.5 * shapes::sphereSpacing(3000, 1));
    for (surfel::Surfel s : small.items) {
        s.position.x += 5;
        s.support = 0.04f;
        list.items.push_back(s);
    }
    MarchingReport report;
    MarchingOptions options;
    options.cell = shapes::sphereSpacing(3000, 1);
    const surface::Surface surface = shapes::surfaceOf(list);
    mesh::marchingCubes(surface, options, report);
    QCOMPARE(report.pieces, std::size_t(2));
    QCOMPARE(report.smallPieces, std::size_t(1));
    options.finishing.dropSmall = true;
    const Mesh m = mesh::marchingCubes(surface, options, report);
    QCOMPARE(topologyOf(m).components, std::size_t(1));
    QCOMPARE(topologyOf(m).unused, std::size_t(0));
    QCOMPARE(m.normals.size(), m.positions.size());
}

/// Linear ones, cut off to a byte: half a step too low.
void MarchingTest::coloursAndMasksAreThoseOfTheSurfels() {
    const double s = shapes::sphereSpacing(4000, 1);
    surfel::SurfelList list = shapes::sphere(4000, 1, 3.5 * s);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = layout->masks = true;
    list.layout = layout;
    for (surfel::Surfel& each : list.items) {
        each.colour = surfel::rgba(static_cast<unsigned>(127 + 100 * each.position.x), 10, 200, 255);
        each.mask = 0.5f + 0.5f * each.position.y;
    }
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(shapes::surfaceOf(list), {}, report);
    QCOMPARE(m.colours.size(), m.positions.size());
    QCOMPARE(m.masks.size(), m.positions.size());
    for (std::size_t v = 0; v < m.positions.size(); ++v) {
        QVERIFY(std::abs(double(m.colours[v] & 255u) - (126.5 + 100 * m.positions[v].x)) < 3);
        QCOMPARE(m.colours[v] >> 8, surfel::rgba(0, 10, 200, 255) >> 8);
        QVERIFY(std::abs(double(m.masks[v]) - (0.5 + 0.5 * m.positions[v].y)) < 0.01);
    }
    list.layout = shapes::layout(true, true);
    QVERIFY(mesh::marchingCubes(shapes::surfaceOf(list), {}, report).colours.empty());
}

void MarchingTest::furtherAttributesAreBlendedAndLabelsKept() {
    const double s = shapes::sphereSpacing(4000, 1);
    surfel::SurfelList list = shapes::sphere(4000, 1, 3.5 * s);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->add("height", surfel::ScalarType::Float64);
    layout->add("side", surfel::ScalarType::UInt8);
    list.layout = layout;
    list.extra.resize(list.size() * layout->words());
    const auto& attributes = layout->attributes();
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::span<std::uint32_t> words{list.extra.data() + i * layout->words(), layout->words()};
        write(attributes[0], words, double(list.items[i].position.z));
        write(attributes[1], words, list.items[i].position.x > 0 ? 7 : 200);
    }
    MarchingReport report;
    const Mesh m = mesh::marchingCubes(shapes::surfaceOf(list), {}, report);
    QCOMPARE(m.extra.size(), m.positions.size() * layout->words());
    for (std::size_t v = 0; v < m.positions.size(); ++v) {
        const std::span<const std::uint32_t> words{m.extra.data() + v * layout->words(), layout->words()};
        QVERIFY(std::abs(read(attributes[0], words) - m.positions[v].z) < 0.01);
        const double side = read(attributes[1], words);
        QVERIFY(side == 7 || side == 200);
        if (std::abs(m.positions[v].x) > s)
            QCOMPARE(side, m.positions[v].x > 0 ? 7.0 : 200.0);
    }
}

void MarchingTest::threadsDoNotShow() {
    const surface::Surface surface = sampled("moebius", test::effort(4000));
    const int threads = base::threadCount();
    std::vector<Mesh> made;
    for (const int count : {1, 2}) {
        base::setThreadCount(count);
        MarchingReport report;
        made.push_back(mesh::marchingCubes(surface, {}, report));
    }
    base::setThreadCount(threads);
    QVERIFY(made[0].positions == made[1].positions);
    QVERIFY(made[0].triangles == made[1].triangles);
}

void MarchingTest::curvesAndNothingAreRefused() {
    MarchingReport report;
    QVERIFY_EXCEPTION_THROWN(mesh::marchingCubes({}, {}, report), base::Error);
    surface::SurfaceDefinition curve;
    curve.manifold = surface::Manifold::Curve;
    const surfel::SurfelList list = shapes::sphere(100, 1, 1);
    QVERIFY_EXCEPTION_THROWN(mesh::marchingCubes(shapes::surfaceOf(list, curve), {}, report), base::Error);
    MarchingOptions fine;
    fine.cell = 1e-9;
    QVERIFY_EXCEPTION_THROWN(mesh::marchingCubes(shapes::surfaceOf(list), fine, report), base::Error);
}

static const test::Registered<MarchingTest> registered;
#include "marching_test.moc"
