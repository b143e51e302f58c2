// What hangs together in faces that come in.
#include "core/mesh/faces/face_topology.h"

#include "core/mesh/faces/polygons.h"
#include "face_models.h"
#include "support/registry.h"

#include <QTest>

using namespace faces;

class FaceTopologyTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void aCubeHasSixPatchesAndIsClosed();
    void flatEdgesAreSmooth();
    void reversedFacesAreTurned();
    void repeatedFacesCountOnce();
    void coincidentCornersAreOneVertex();
    void trianglesWithCornersAtOnePlaceAreNone();
    void roundOffDoesNotOpenSeams();
    void smallSheetsOfLargeScenesKeepTheirBorders();
    void cornersOnSidesOpenNothing();
    void aMoebiusStripIsOneSided();
    void cutPolygonsKeepTheirArea();
};

void FaceTopologyTest::aCubeHasSixPatchesAndIsClosed() {
    const FaceTopology cube = box({1, 1, 1}).topology();
    QVERIFY(cube.closed() && !cube.oneSided);
    QCOMPARE(cube.patchCount, std::size_t(6));
    QCOMPARE(cube.fanCount, std::size_t(24));
    QCOMPARE(cube.area, 6.0);
    Faces open = box({1, 1, 1});
    open.triangles.pop_back();
    QCOMPARE(open.topology().borders, std::size_t(3));
}

void FaceTopologyTest::flatEdgesAreSmooth() {
    const Faces torus = band(64, 32, false);
    QCOMPARE(torus.topology().patchCount, std::size_t(1));
    QCOMPARE(torus.topology().fanCount, torus.positions.size());
    QVERIFY(torus.topology(0).patchCount > torus.triangles.size() * 9 / 10); // some quads are flat within rounding
    QCOMPARE(box({1, 1, 1}).topology(std::numeric_limits<double>::infinity()).fanCount, std::size_t(8));
}

void FaceTopologyTest::reversedFacesAreTurned() {
    const Faces whole = band(30, 12, false);
    Faces turned = whole;
    base::Random random(test::seed());
    std::size_t count = 0;
    for (Triangle& t : turned.triangles)
        if (random.below(5) == 0)
            std::swap(t[0], t[1]), ++count;
    const FaceTopology expected = whole.topology(), found = turned.topology();
    QCOMPARE(expected.reversed, std::size_t(0));
    QCOMPARE(found.reversed, count);
    for (std::size_t t = 0; t < expected.normals.size(); ++t)
        QVERIFY(distance(found.normals[t], expected.normals[t]) < 1e-12);
}

void FaceTopologyTest::repeatedFacesCountOnce() {
    Faces cube = box({1, 1, 1});
    cube.triangles.push_back(cube.triangles[3]);
    cube.triangles.push_back({cube.triangles[5][1], cube.triangles[5][0], cube.triangles[5][2]});
    const FaceTopology found = cube.topology();
    QCOMPARE(found.repeated, std::size_t(2));
    Faces fine = band(60, 30, false);
    fine.triangles.push_back(fine.triangles[7]); // a fin of two sides on a triangle: as given, every edge is even
    fine.triangles.push_back({fine.triangles[7][1], fine.triangles[7][0], fine.triangles[7][2]});
    QVERIFY(fine.topology().closed());
    QVERIFY(found.closed());
    QCOMPARE(found.area, 6.0);
}

void FaceTopologyTest::coincidentCornersAreOneVertex() {
    const Faces cube = box({2, 1, 0.5f});
    Faces stl;
    for (const Triangle& t : cube.triangles) {
        const auto first = static_cast<std::uint32_t>(stl.positions.size());
        for (const std::uint32_t corner : t)
            stl.positions.push_back(cube.positions[corner]);
        stl.triangles.push_back({first, first + 1, first + 2});
    }
    const FaceTopology found = stl.topology();
    QVERIFY(found.closed());
    QCOMPARE(found.patchCount, std::size_t(6));
    QCOMPARE(found.fanCount, std::size_t(24));
}

void FaceTopologyTest::trianglesWithCornersAtOnePlaceAreNone() { // whatever the numbers of the corners
    const Faces whole = box({1, 1, 1});
    Faces more = whole;
    base::Random random(test::seed());
    for (std::size_t i = 0; i < 5; ++i) {
        const Triangle& t = whole.triangles[random.below(whole.triangles.size())];
        const auto again = static_cast<std::uint32_t>(more.positions.size());
        more.positions.push_back(more.positions[t[0]]);
        more.triangles.insert(more.triangles.begin() + static_cast<std::ptrdiff_t>(random.below(4)),
                              Triangle{t[0], again, t[1]});
    }
    const FaceTopology found = more.topology(), expected = whole.topology();
    QVERIFY(found.closed() && found.nonManifold == 0 && found.repeated == 0);
    QCOMPARE(found.triangles.size(), whole.triangles.size());
    QCOMPARE(found.sharpEdges.size(), expected.sharpEdges.size());
    QCOMPARE(found.patchCount, std::size_t(6));
    Faces none;
    none.positions.assign(3, {1, 2, 3});
    none.triangles = {{0, 1, 2}};
    QVERIFY(none.topology().triangles.empty() && !none.topology().closed());
}

void FaceTopologyTest::roundOffDoesNotOpenSeams() {
    const Faces cube = box({2, 1, 0.5f});
    base::Random random(test::seed());
    Faces stl;
    for (const Triangle& t : cube.triangles) {
        const auto first = static_cast<std::uint32_t>(stl.positions.size());
        for (const std::uint32_t corner : t)
            stl.positions.push_back(cube.positions[corner] + base::cast<float>(random.unitVector() * 3e-7));
        stl.triangles.push_back({first, first + 1, first + 2});
    }
    QVERIFY2(stl.topology().closed(), qPrintable(QString("seed %1").arg(test::seed())));
    QCOMPARE(stl.topology().patchCount, std::size_t(6));
    stl.positions[0].x += 0.01f; // a gap is a gap
    QVERIFY(!stl.topology().closed());
}

/// A sheet of 16 squares smaller than the round-off of the whole scene's extent.
void FaceTopologyTest::smallSheetsOfLargeScenesKeepTheirBorders() {
    Faces scene = box({2000, 2000, 2000});
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (std::uint32_t i = 0; i < 25; ++i)
        scene.positions.push_back({-1e-4f * static_cast<float>(i % 5), -1e-4f * static_cast<float>(i / 5), 0});
    for (std::uint32_t i = 0; i < 20; ++i)
        if (i % 5 < 4) {
            const std::uint32_t a = first + i;
            scene.triangles.push_back({a, a + 1, a + 6});
            scene.triangles.push_back({a, a + 6, a + 5});
        }
    const FaceTopology found = scene.topology();
    QCOMPARE(found.borders, std::size_t(16));
    QVERIFY(!found.closed());
}

/// Triangles cut one by one, at random places of their sides, each with corners of its own and turned by chance.
void FaceTopologyTest::cornersOnSidesOpenNothing() {
    for (int round = 0; round < test::effort(20); ++round) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(round);
        base::Random random(seed);
        Faces faces = round % 2 == 0 ? box({2, 1, 0.5f}) : band(20, 9, false);
        const FaceTopology whole = faces.topology();
        for (int times = 0; times < 4; ++times)
            for (std::size_t t = 0, count = faces.triangles.size(); t < count; ++t) {
                if (random.below(3) == 0)
                    continue;
                const std::size_t k = random.below(3);
                const Triangle f = faces.triangles[t];
                const auto p = [&](std::size_t i) { return base::cast<double>(faces.positions[f[i % 3]]); };
                faces.positions.push_back(base::cast<float>(p(k) + (p(k + 1) - p(k)) * random.uniform(0.1, 0.9)));
                const auto cut = static_cast<std::uint32_t>(faces.positions.size() - 1);
                faces.triangles[t] = {f[k], cut, f[(k + 2) % 3]};
                faces.triangles.push_back({cut, f[(k + 1) % 3], f[(k + 2) % 3]});
            }
        Faces apart;
        for (Triangle t : faces.triangles) {
            if (random.below(3) == 0)
                std::swap(t[0], t[1]);
            const auto first = static_cast<std::uint32_t>(apart.positions.size());
            for (const std::uint32_t corner : t)
                apart.positions.push_back(faces.positions[corner]);
            apart.triangles.push_back({first, first + 1, first + 2});
        }
        const FaceTopology found = apart.topology();
        const QByteArray told = QString("seed %1").arg(seed).toUtf8();
        QVERIFY2(found.closed() && !found.oneSided, told);
        QCOMPARE(found.patchCount, whole.patchCount);
        Vec3d sum;
        double volume = 0;
        for (std::size_t t = 0; t < found.triangles.size(); ++t) {
            sum += found.normals[t] * found.areas[t];
            volume +=
                dot(base::cast<double>(apart.positions[found.triangles[t][0]]), found.normals[t]) * found.areas[t] / 3;
        }
        QVERIFY2(length(sum) < 1e-4, told); // all turned alike
        QVERIFY2(volume > 0.9, told);       // and outwards
    }
    Faces open = box({2, 1, 0.5f}); // a gap is a gap
    open.positions.push_back({1, 0, 0.01f});
    open.triangles[4] = {0, 8, 5};
    open.triangles.push_back({8, 1, 5});
    QVERIFY(!open.topology().closed());
}

void FaceTopologyTest::aMoebiusStripIsOneSided() {
    QVERIFY(band(40, 6, true).topology().oneSided);
    QVERIFY(!band(40, 6, true).topology().closed());
    QVERIFY(!band(40, 6, false).topology().oneSided);
}

/// Stars have dents at every other corner; in a random plane, and with repeated corners.
void FaceTopologyTest::cutPolygonsKeepTheirArea() {
    for (int round = 0; round < test::effort(100); ++round) {
        base::Random random(test::seed() + static_cast<std::uint64_t>(round));
        const Vec3d n = random.unitVector(), u = base::perpendicular(n), v = cross(n, u);
        const std::size_t corners = 3 + random.below(20);
        std::vector<Vec3f> positions;
        mesh::Polygons star;
        double area = 0;
        std::vector<std::pair<double, double>> flat;
        for (std::size_t k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
            const double r = random.uniform(0.2, 1);
            flat.emplace_back(r * std::cos(angle), r * std::sin(angle));
            positions.push_back(base::cast<float>(u * flat.back().first + v * flat.back().second));
            star.corners.push_back(static_cast<std::uint32_t>(k));
            if (random.below(4) == 0)
                star.corners.push_back(static_cast<std::uint32_t>(k));
        }
        star.close();
        for (std::size_t k = 0; k < corners; ++k) {
            const auto& [ax, ay] = flat[k];
            const auto& [bx, by] = flat[(k + 1) % corners];
            area += (ax * by - bx * ay) / 2;
        }
        const std::vector<Triangle> cut = triangulated(star, positions);
        QCOMPARE(cut.size(), corners - 2);
        QVERIFY2(std::abs(areaOf(positions, cut) - area) < 1e-5,
                 qPrintable(QString("seed %1").arg(test::seed() + static_cast<std::uint64_t>(round))));
    }
}

static const test::Registered<FaceTopologyTest> registered;
#include "face_topology_test.moc"
