// Coarsening a triangulation: fewer vertices, the same surface.
#include "core/mesh/check/topology.h"
#include "core/mesh/delaunay/coarsen.h"
#include "core/mesh/marching/marching_cubes.h"
#include "mesh/models.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::SurfaceTriangulation;

class CoarsenTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void topologyStays_data();
    void topologyStays();
    void sidesGrowToTheSize();
    void rimsKeepTheirCourse();
    void sharpCornersAreCutOff();
};

namespace {

Mesh cubesOf(const surface::Surface& surface) {
    mesh::MarchingReport report;
    return mesh::marchingCubes(surface, {}, report);
}

Mesh coarse(const surface::Surface& surface, const Mesh& fine, double size, double distance) {
    SurfaceTriangulation faces(surface, fine);
    mesh::coarsen(
        faces, [size](const Vec3d&) { return size; }, distance);
    return faces.mesh(std::vector<bool>(faces.faceCount()));
}

double spacingOf(const surface::Surface& surface) {
    return double(surface.tree().maxSupport()) * surface::spacingOfUnit;
}

} // namespace

void CoarsenTest::topologyStays_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"sphere", "torus", "knot", "moebius"})
        QTest::addRow("%s", name) << QString(name);
}

void CoarsenTest::topologyStays() {
    QFETCH(QString, name);
    const surface::Surface surface =
        models::sampled(name.toLatin1().constData(), static_cast<std::size_t>(test::effort(4000)));
    const Mesh fine = cubesOf(surface);
    const double s = spacingOf(surface);
    const Mesh made = coarse(surface, fine, 1.5 * s, 0.1 * s);
    const mesh::Topology before = mesh::topologyOf(fine.triangles, fine.positions.size());
    const mesh::Topology after = mesh::topologyOf(made.triangles, made.positions.size());
    QVERIFY(after.manifold());
    QCOMPARE(after.euler(), before.euler());
    QCOMPARE(after.boundaryLoops, before.boundaryLoops);
    QCOMPARE(after.orientable, before.orientable);
    QVERIFY(made.triangles.size() < fine.triangles.size() / 2);
    const SurfaceTriangulation faces(surface, made);
    for (const mesh::Triangle& t : made.triangles)
        QVERIFY2(std::abs(faces.facing(t)) > 0.8, QByteArray::number(faces.facing(t)));
}

/// Where nothing bends, no side is left that is shorter than the size.
void CoarsenTest::sidesGrowToTheSize() {
    const surface::Surface surface = models::sampled("sphere", 4000);
    const double size = 2 * spacingOf(surface);
    const Mesh made = coarse(surface, cubesOf(surface), size, size);
    std::size_t shorter = 0;
    for (const mesh::Triangle& t : made.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            shorter += distance(made.positions[t[k]], made.positions[t[(k + 1) % 3]]) < size;
    QVERIFY2(shorter <= made.triangles.size() / 50, QByteArray::number(shorter));
}

void CoarsenTest::rimsKeepTheirCourse() {
    const surface::Surface surface = models::halfSphere(3000);
    const Mesh fine = cubesOf(surface);
    const double s = spacingOf(surface), farthest = 0.05 * s;
    const Mesh made = coarse(surface, fine, 4 * s, farthest);
    const auto boundaryOf = [](const Mesh& m) {
        std::vector<std::pair<Vec3d, Vec3d>> out;
        const mesh::Triangulation faces(m.triangles, m.positions.size());
        for (std::uint32_t f = 0; f < faces.faceCount(); ++f)
            for (int k = 0; k < 3; ++k)
                if (const mesh::Side side{f, k}; faces.onBoundary(side))
                    out.emplace_back(m.positions[faces.from(side)], m.positions[faces.to(side)]);
        return out;
    };
    const auto before = boundaryOf(fine), after = boundaryOf(made);
    QVERIFY(!after.empty() && after.size() < before.size());
    double worst = 0;
    for (const auto& [p, q] : before) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& [a, b] : after) {
            const double t = std::clamp(dot(p - a, b - a) / lengthSq(b - a), 0.0, 1.0);
            nearest = std::min(nearest, distance(p, a + (b - a) * t));
        }
        worst = std::max(worst, nearest);
    }
    // Each step keeps to half of it; several after each other may add up.
    QVERIFY2(worst <= 2 * farthest, QByteArray::number(worst / farthest));
}

/// A spike of one triangle on the boundary.
void CoarsenTest::sharpCornersAreCutOff() {
    const surface::Surface surface = models::sampled("sphere", 1000);
    Mesh m;
    m.positions = {{0, 0, 1}, {0.1, 0, 1}, {0.1, 0.1, 1}, {0, 0.1, 1}, {0.05, -0.5, 1}};
    m.normals.assign(5, {0, 0, 1});
    m.kinds.assign(5, mesh::VertexKind::Fold);
    m.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}};
    const Mesh made = coarse(surface, m, 1e-3, 1e-3);
    QCOMPARE(made.triangles, (std::vector<mesh::Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

static const test::Registered<CoarsenTest> registered;
#include "coarsen_test.moc"
