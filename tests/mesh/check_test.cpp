#include "core/base/random.h"
#include "core/mesh/check/check.h"
#include "core/surface/projection/project.h"

#include "mesh/meshes.h"
#include "support/registry.h"
#include "surface/shapes.h"
#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::Report;

class CheckTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void anglesAreThoseOfElementaryGeometry();
    void trianglesWithoutAreaAreFound();
    void areaAndEdgesOfAGridAreExact();
    void distancesToASphereAreThoseOfItsRadius();
    void distancesBeyondTheBoundaryAreToIt();
    void farPlacesAreLost();
};

namespace {

constexpr double degree = meshes::pi / 180;

surface::Surface sphereOf(std::size_t count) {
    const double s = shapes::sphereSpacing(count, 1);
    return {tree::SurfelTree::build(shapes::sphere(count, 1, 3.5 * s)), {}};
}

} // namespace

void CheckTest::anglesAreThoseOfElementaryGeometry() {
    QCOMPARE(mesh::smallestAngle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), 45 * degree);
    QCOMPARE(mesh::smallestAngle({0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3.0), 0}), 60 * degree);
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int i = 0; i < test::effort(2000); ++i) {
        Vec3d p[3];
        for (Vec3d& v : p)
            v = random.unitVector() * random.uniform(0, 10);
        double least = 4;
        for (int k = 0; k < 3; ++k) {
            const Vec3d a = base::normalized(p[(k + 1) % 3] - p[k]), b = base::normalized(p[(k + 2) % 3] - p[k]);
            least = std::min(least, std::atan2(length(cross(a, b)), dot(a, b)));
        }
        QVERIFY2(std::abs(mesh::smallestAngle(p[0], p[1], p[2]) - least) < 1e-9,
                 QByteArray("seed ") + QByteArray::number(seed));
    }
}

void CheckTest::trianglesWithoutAreaAreFound() {
    Mesh m = meshes::tetrahedron();
    m.positions.push_back({0.5, 0, 0});
    m.triangles.push_back({0, 1, 4}); // on a line
    m.triangles.push_back({2, 2, 3});
    const mesh::Shape s = mesh::shapeOf(m);
    QCOMPARE(s.degenerate, std::size_t(2));
    QCOMPARE(s.leastAngle, 0.0);
    QCOMPARE(mesh::shapeOf({}).degenerate, std::size_t(0));
}

void CheckTest::areaAndEdgesOfAGridAreExact() {
    const mesh::Shape s = mesh::shapeOf(meshes::tetrahedron());
    QVERIFY(std::abs(s.area - (1.5 + std::sqrt(3.0) / 2)) < 1e-12);
    QCOMPARE(s.shortestEdge, 1.0);
    QCOMPARE(s.longestEdge, std::sqrt(2.0));
    QCOMPARE(s.leastAngle, 45 * degree);
    // of many, in parallel: the sphere's from inside
    const mesh::Shape ball = mesh::shapeOf(meshes::sphere(6));
    QVERIFY(ball.area < 4 * meshes::pi && ball.area > 4 * meshes::pi * 0.999);
}

void CheckTest::distancesToASphereAreThoseOfItsRadius() {
    const surface::Surface surface = sphereOf(2000);
    const double rho = 1 + surface.evaluateReference({0, 0, 1}).value * -1; // the level through the pole, near enough
    Mesh m = meshes::sphere(4);
    for (Vec3d& v : m.positions)
        v *= 1.01;
    const Report r = mesh::check(m, surface);
    QCOMPARE(r.vertices.count, m.positions.size());
    QCOMPARE(r.faces.count, m.triangles.size());
    QCOMPARE(r.vertices.lost + r.faces.lost, std::size_t(0));
    QVERIFY2(std::abs(r.vertices.max - (1.01 - rho)) < 2e-4, QByteArray::number(r.vertices.max - (1.01 - rho)));
    QVERIFY(r.vertices.median <= r.vertices.hundredth && r.vertices.hundredth <= r.vertices.max);
    QVERIFY(r.faces.median < r.vertices.median); // the centres lie lower
    // Projected vertices are on the surface, whatever way the distance is found.
    for (Vec3d& v : m.positions)
        v = projectReference(surface, v, {}).foot;
    const Report on = mesh::check(m, surface);
    QVERIFY2(on.vertices.max < 1e-10, QByteArray::number(on.vertices.max));
    QVERIFY(on.faces.max > 1e-4 && on.faces.max < 5e-3);
}

void CheckTest::distancesBeyondTheBoundaryAreToIt() {
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.3f;
    const surface::Surface surface{tree::SurfelTree::build(shapes::plane(12, 0.1, 0.35)), definition};
    // The grid ends at 1.2; seek where the surface does by the distances themselves.
    const double a = mesh::distanceTo(surface, {1.3, 0.013, 0}, {}),
                 b = mesh::distanceTo(surface, {1.35, 0.013, 0}, {});
    QVERIFY2(a > 0.01 && std::abs(b - a - 0.05) < 5e-3, QByteArray::number(a) + ' ' + QByteArray::number(b));
    QVERIFY(std::abs(mesh::distanceTo(surface, {0.2, 0.3, 0.07}, {}) - 0.07) < 1e-9);
}

void CheckTest::farPlacesAreLost() {
    Mesh m = meshes::tetrahedron({50, 0, 0});
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.3f;
    const surface::Surface surface{tree::SurfelTree::build(shapes::plane(12, 0.1, 0.35)), definition};
    QCOMPARE(mesh::vertexDeviation(m, surface).lost, std::size_t(4));
    QCOMPARE(mesh::distanceTo(surface, {50, 0, 0}, {}), std::numeric_limits<double>::infinity());
}

static const test::Registered<CheckTest> registered;
#include "check_test.moc"
