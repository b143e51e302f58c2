#include "core/base/random.h"
#include "core/mesh/check/self_intersections.h"

#include "mesh/meshes.h"
#include "support/registry.h"
#include <QTest>

using base::Vec3d, mesh::Mesh, mesh::selfIntersections;

class SelfIntersectionsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void goodMeshesHaveNone();
    void crossingTetrahedraAreFound();
    void neighboursMayOnlyShareWhatTheyName();
    void trianglesWithoutAreaAreLeftOut();
    void randomSoupsAgreeWithSegments();
};

namespace {

/// Does the open segment cross the inside of the triangle? For positions without coincidences.
bool crosses(const Vec3d& p, const Vec3d& q, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto volume = [](const Vec3d& o, const Vec3d& x, const Vec3d& y, const Vec3d& z) {
        return dot(cross(x - o, y - o), z - o) > 0;
    };
    if (volume(p, a, b, c) == volume(q, a, b, c))
        return false;
    const bool ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return ab == bc && bc == ca;
}

} // namespace

void SelfIntersectionsTest::goodMeshesHaveNone() {
    for (const Mesh& m : {meshes::tetrahedron(), meshes::torus(12, 20), meshes::moebius(30), meshes::sphere(3)})
        QVERIFY(selfIntersections(m).empty());
    QVERIFY(selfIntersections({}).empty());
}

void SelfIntersectionsTest::crossingTetrahedraAreFound() {
    const Mesh m = meshes::together(meshes::tetrahedron(), meshes::tetrahedron({0.1, 0.1, 0.5}));
    const auto found = selfIntersections(m);
    QVERIFY(!found.empty());
    for (const auto& [a, b] : found)
        QVERIFY(a < 4 && b >= 4);
    QVERIFY(selfIntersections(meshes::together(meshes::tetrahedron(), meshes::tetrahedron({3, 0, 0}))).empty());
}

void SelfIntersectionsTest::neighboursMayOnlyShareWhatTheyName() {
    Mesh m;
    m.positions = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, 1}, {1, 0.5, 0}, {0, -1, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}};
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    m.triangles = {{0, 1, 2}, {1, 0, 3}}; // along an edge, at an angle
    QCOMPARE(selfIntersections(m), Pairs{});
    m.triangles = {{0, 1, 2}, {1, 0, 5}}; // in one plane, beside each other
    QCOMPARE(selfIntersections(m), Pairs{});
    m.triangles = {{0, 1, 2}, {1, 0, 4}}; // in one plane, folded over
    QCOMPARE(selfIntersections(m), (Pairs{{0, 1}}));
    m.triangles = {{0, 1, 2}, {0, 6, 7}}; // a common corner, and through
    QCOMPARE(selfIntersections(m), (Pairs{{0, 1}}));
    m.triangles = {{0, 1, 2}, {0, 5, 3}}; // a common corner only
    QCOMPARE(selfIntersections(m), Pairs{});
    m.triangles = {{0, 1, 2}, {2, 0, 1}}; // twice
    QCOMPARE(selfIntersections(m), (Pairs{{0, 1}}));
}

void SelfIntersectionsTest::trianglesWithoutAreaAreLeftOut() {
    Mesh m = meshes::tetrahedron();
    m.positions.push_back({0.5, 0, 0});
    m.triangles.push_back({0, 1, 4});
    m.triangles.push_back({1, 1, 2});
    QVERIFY(selfIntersections(m).empty());
}

void SelfIntersectionsTest::randomSoupsAgreeWithSegments() {
    const unsigned long long seed = test::seed();
    base::Random random(seed);
    for (int round = 0; round < test::effort(20); ++round) {
        Mesh m;
        for (std::uint32_t f = 0; f < 40; ++f) {
            const Vec3d centre = random.unitVector() * random.uniform();
            for (int k = 0; k < 3; ++k)
                m.positions.push_back(centre + random.unitVector() * 0.4);
            m.triangles.push_back({3 * f, 3 * f + 1, 3 * f + 2});
        }
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
        for (std::uint32_t a = 0; a < 40; ++a)
            for (std::uint32_t b = a + 1; b < 40; ++b) {
                bool any = false;
                for (const auto& [s, t] : {std::pair(a, b), std::pair(b, a)})
                    for (std::size_t k = 0; k < 3; ++k)
                        any |= crosses(m.positions[3 * s + k], m.positions[3 * s + (k + 1) % 3], m.positions[3 * t],
                                       m.positions[3 * t + 1], m.positions[3 * t + 2]);
                if (any)
                    expected.emplace_back(a, b);
            }
        QVERIFY(!expected.empty());
        QVERIFY2(selfIntersections(m) == expected, QByteArray("seed ") + QByteArray::number(seed));
    }
}

static const test::Registered<SelfIntersectionsTest> registered;
#include "self_intersections_test.moc"
