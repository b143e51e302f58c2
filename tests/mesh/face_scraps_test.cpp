// Scraps and parts of triangles stand for all of them, and those of slivers are no millions.
#include "core/mesh/faces/face_scraps.h"

#include "core/mesh/faces/face_density.h"
#include "face_models.h"
#include "support/registry.h"

#include <QTest>

using namespace faces;
using mesh::Scrap;

class FaceScrapsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void scrapsStandForTheirTriangles();
    void sliversHaveAsManyAsTheyAreLong();
    void noModelHasMoreThanTheMost();
    void partsOfOneSpacingCoverTheirTriangles();
    void partsOfSliversAreAsManyAsTheyAreLong();
};

void FaceScrapsTest::scrapsStandForTheirTriangles() {
    const Faces faces = soup(test::seed(), 300);
    const FaceTopology topology = faces.topology();
    base::Random random(test::seed());
    std::vector<double> sizes(topology.triangles.size()), areas(sizes.size());
    for (double& size : sizes)
        size = random.uniform(0.02, 1);
    for (const Scrap& each : mesh::scrapsOf(topology, faces.positions, sizes)) {
        areas[each.triangle] += static_cast<double>(each.area);
        const auto corner = [&](std::size_t k) {
            return base::cast<double>(faces.positions[topology.triangles[each.triangle][k]]);
        };
        for (std::size_t k = 0; k < 3; ++k) // inside of all three sides
            QVERIFY(dot(cross(corner((k + 1) % 3) - corner(k), base::cast<double>(each.place) - corner(k)),
                        topology.normals[each.triangle]) > -1e-6);
        QVERIFY(static_cast<double>(each.area) < 2 * sizes[each.triangle] * sizes[each.triangle]);
    }
    for (std::size_t t = 0; t < areas.size(); ++t)
        QVERIFY2(std::abs(areas[t] - topology.areas[t]) <= 1e-5 * topology.areas[t],
                 qPrintable(QString("seed %1").arg(test::seed())));
}

/// A strip of them, as cylinders are saved.
static Faces strip(std::uint32_t count) {
    Faces out;
    for (std::uint32_t i = 0; i <= count; ++i) {
        const float y = 1e-3f * static_cast<float>(i);
        out.positions.insert(out.positions.end(), {{0, y, 0}, {10, y, 0}});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        out.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
        out.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
    return out;
}

void FaceScrapsTest::sliversHaveAsManyAsTheyAreLong() {
    const Faces faces = strip(50);
    const std::vector<double> sizes(faces.triangles.size(), 0.01);
    const std::size_t found = mesh::scrapsOf(faces.topology(), faces.positions, sizes).size();
    QVERIFY2(found > 95'000 && found < 105'000, qPrintable(QString::number(found)));
}

void FaceScrapsTest::noModelHasMoreThanTheMost() {
    const Faces faces = strip(50);
    for (const double size : {1e-3, 1e-9, 1e-300})
        for (const std::size_t most : {0, 1000, 10'000}) {
            const std::vector<double> sizes(faces.triangles.size(), size);
            const std::size_t found = mesh::scrapsOf(faces.topology(), faces.positions, sizes, most).size();
            QVERIFY2(found >= faces.triangles.size() && found <= most + faces.triangles.size(),
                     qPrintable(QString("%1 of %2").arg(found).arg(most)));
        }
}

/// Parts as small as one place asks for.
static std::vector<mesh::FacePart> partsOf(const Faces& faces, const Vec3d& place, double spacing) {
    const FaceTopology topology = faces.topology();
    return mesh::FaceDensity(topology, faces.positions, std::vector<double>(topology.pieceCount, 1e3),
                             {{place, spacing, 20}}, 0.1)
        .parts();
}

void FaceScrapsTest::partsOfOneSpacingCoverTheirTriangles() {
    const Faces faces = soup(test::seed(), 300);
    const FaceTopology topology = faces.topology();
    std::vector<double> shares(topology.triangles.size());
    for (const mesh::FacePart& each : partsOf(faces, {0.3, 0.2, 0.1}, 0.02)) {
        const float u = each.b[1] - each.b[0], v = each.c[2] - each.c[0], x = each.b[2] - each.b[0];
        const float area = u * v - x * (each.c[1] - each.c[0]);
        QVERIFY(area > -1e-6f);
        shares[each.triangle] += static_cast<double>(area);
    }
    for (std::size_t t = 0; t < shares.size(); ++t)
        QVERIFY2(std::abs(shares[t] - (topology.areas[t] > 0 ? 1 : 0)) < 1e-3,
                 qPrintable(QString("%1, seed %2").arg(shares[t]).arg(test::seed())));
}

void FaceScrapsTest::partsOfSliversAreAsManyAsTheyAreLong() {
    const std::size_t coarse = partsOf(strip(50), {5, 0, 0}, 0.2).size(),
                      fine = partsOf(strip(50), {5, 0, 0}, 0.02).size();
    QVERIFY2(coarse > 100 && fine < 16 * coarse, qPrintable(QString("%1 and %2").arg(coarse).arg(fine)));
}

static const test::Registered<FaceScrapsTest> registered;
#include "face_scraps_test.moc"
