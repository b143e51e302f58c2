// Areas and volumes of surfaces, against what is known of them.
#include "core/mesh/extent/extent.h"

#include "cells/solids.h"
#include "core/base/random.h"
#include "core/mesh/faces/open_faces.h"
#include "mesh/face_models.h"
#include "mesh/models.h"
#include "support/registry.h"
#include "support/sanitized.h"
#include "support/threads.h"

#include <numbers>
#include <QTest>

using mesh::Extent;
using mesh::extentOf;
using std::numbers::pi;

class ExtentTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void spheresAreWithinAThousandth();
    void toriAreWithinAThousandth();
    void boxesGainWithTheirPoints();
    void creasesAreMeasuredSharp();
    void errorsAtAcuteEdgesAreTold();
    void openSurfacesHaveAreaAndNoVolume();
    void oneSidedSurfacesHaveNoVolume();
    void theSideOfNormalsDoesNotMatter();
    void placeAndCellDoNotMatter();
    void threadsDoNotShow();
};

namespace {

QByteArray told(double value, double wanted) {
    return QByteArray::number(value, 'g', 9) + " for " + QByteArray::number(wanted, 'g', 9);
}

surface::Surface torusOf(double spacing) {
    return shapes::surfaceOf(shapes::torus(1, 0.4, spacing, 3.5 * spacing));
}

surface::Surface sphereOf(std::size_t count, double radius) {
    return shapes::surfaceOf(shapes::sphere(count, radius, 3.5 * shapes::sphereSpacing(count, radius)));
}

} // namespace

void ExtentTest::spheresAreWithinAThousandth() {
    for (const std::size_t count : {400u, 3000u})
        for (const double radius : {1.0, 250.0}) {
            const Extent e = extentOf(sphereOf(count, radius));
            const double area = 4 * pi * radius * radius, volume = area * radius / 3;
            QVERIFY2(std::abs(e.area / area - 1) < 1e-3, told(e.area, area));
            QVERIFY2(e.closed && std::abs(e.volume / volume - 1) < 1e-3, told(e.volume, volume));
            QVERIFY2(e.areaError < 0.02 * area && e.flat == 0, told(e.areaError, area));
        }
}

void ExtentTest::toriAreWithinAThousandth() {
    const Extent e = extentOf(torusOf(0.06));
    const double area = 4 * pi * pi * 0.4, volume = 2 * pi * pi * 0.16;
    QVERIFY2(std::abs(e.area / area - 1) < 1e-3, told(e.area, area));
    QVERIFY2(e.closed && std::abs(e.volume / volume - 1) < 1e-3, told(e.volume, volume));
}

/// Edges are as round as the supports make them: what they lose goes with the spacing.
void ExtentTest::boxesGainWithTheirPoints() {
    const Extent coarse = extentOf(models::cube(20)), fine = extentOf(models::cube(40));
    QVERIFY2(fine.closed && std::abs(fine.volume / 8 - 1) < 0.004, told(fine.volume, 8));
    QVERIFY2(std::abs(fine.area / 24 - 1) < 0.02, told(fine.area, 24));
    QVERIFY2(24 - fine.area < 0.6 * (24 - coarse.area), told(coarse.area, fine.area));
}

/// A cube, and an octant of a ball, whose seams are bent: what rounded edges would lose is there.
void ExtentTest::creasesAreMeasuredSharp() {
    if (test::sanitized)
        QSKIP("takes a minute under a sanitizer");
    base::Random random(test::seed());
    const auto cube = plane_solids::sampled(plane_solids::cube(0.8), 2.4, 0.1, random);
    const Extent a = extentOf(plane_solids::surfaceOf(cube.surfels));
    const Extent b = extentOf(plane_solids::surfaceOf(plane_solids::octant(0.06, random)));
    QVERIFY2(std::abs(a.area / (6 * 1.6 * 1.6) - 1) < 1e-3, told(a.area, 6 * 1.6 * 1.6));
    QVERIFY2(a.closed && std::abs(a.volume / (1.6 * 1.6 * 1.6) - 1) < 1e-3, told(a.volume, 1.6 * 1.6 * 1.6));
    QVERIFY2(std::abs(b.area / (1.25 * pi) - 1) < 2e-3, told(b.area, 1.25 * pi));
    QVERIFY2(b.closed && std::abs(b.volume / (pi / 6) - 1) < 2e-3, told(b.volume, pi / 6));
}

void ExtentTest::errorsAtAcuteEdgesAreTold() {
    std::size_t rounds = 0, missed = 0;
    QByteArray all;
    for (; rounds < std::size_t(test::effort(test::sanitized ? 1 : 6)); ++rounds) {
        const std::uint64_t seed = test::seed() + rounds;
        base::Random random(seed);
        const double a = random.uniform(12, 80) * pi / 360, h = random.uniform(0.3, 1), turn = random.uniform(0, 1);
        faces::Faces wedge; // with the z axis as its edge, turned about x
        const double c = std::cos(turn), s = std::sin(turn);
        for (const double z : {0.0, h})
            for (const auto& [x, y] : {std::pair(0.0, 0.0), {1.0, -std::tan(a)}, {1.0, std::tan(a)}})
                wedge.positions.push_back(base::cast<float>(base::Vec3d{x, c * y - s * z, s * y + c * z}));
        wedge.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
        const mesh::OpenedFaces found = mesh::openFaces(wedge.list(), wedge.triangles, {},
                                                        {.use = mesh::FaceUse::Sample, .count = 4000, .creases = true});
        surface::SurfaceDefinition definition;
        definition.boundary = surface::Boundary::None;
        definition.boundaryLimit = std::numeric_limits<float>::infinity();
        definition.oneSheet = !found.apart;
        const Extent e = extentOf({tree::SurfelTree::build(found.points), definition});
        const double volume = std::tan(a) * h, area = 2 * std::tan(a) + 2 * h * std::tan(a) + 2 * h / std::cos(a);
        const bool holds =
            e.closed && std::abs(e.volume - volume) <= e.volumeError && std::abs(e.area - area) <= e.areaError;
        missed += holds ? 0 : 1;
        all += "seed " + QByteArray::number(qulonglong(seed)) + ": " + told(e.volume, volume) + " +- " +
               QByteArray::number(e.volumeError) + ", " + told(e.area, area) + " +- " +
               QByteArray::number(e.areaError) + "\n";
    }
    QVERIFY2(missed * 6 <= rounds, all);
}

void ExtentTest::openSurfacesHaveAreaAndNoVolume() {
    const Extent e = extentOf(models::halfSphere(6000));
    QVERIFY(!e.closed && e.boundaryEdges > 0 && e.orientable && e.volume == 0);
    const double strip = 2 * pi * shapes::sphereSpacing(6000, 1); // it ends within a spacing of the rim
    QVERIFY2(std::abs(e.area - 2 * pi) < strip, told(e.area, 2 * pi));
}

void ExtentTest::oneSidedSurfacesHaveNoVolume() {
    const Extent e = extentOf(models::sampled("moebius", 3000));
    QVERIFY(!e.orientable && !e.closed && e.area > 0 && e.volume == 0);
}

void ExtentTest::theSideOfNormalsDoesNotMatter() {
    surfel::SurfelList list = shapes::sphere(2000, 1, 3.5 * shapes::sphereSpacing(2000, 1));
    for (surfel::Surfel& s : list.items)
        s.normal = -s.normal;
    const Extent e = extentOf(shapes::surfaceOf(list));
    QVERIFY2(e.closed && std::abs(e.volume / (4 * pi / 3) - 1) < 1e-3, told(e.volume, 4 * pi / 3));
}

void ExtentTest::placeAndCellDoNotMatter() {
    surfel::SurfelList list = shapes::sphere(3000, 1, 3.5 * shapes::sphereSpacing(3000, 1));
    const double wanted = extentOf(shapes::surfaceOf(list)).area;
    for (surfel::Surfel& s : list.items)
        s.position += base::Vec3f{3, -5, 7};
    const double moved = extentOf(shapes::surfaceOf(list)).area, finer = extentOf(shapes::surfaceOf(list), 0.03).area;
    QVERIFY2(std::abs(moved / wanted - 1) < 2e-4 && std::abs(finer / wanted - 1) < 2e-4, told(moved, wanted));
}

void ExtentTest::threadsDoNotShow() {
    const surface::Surface torus = torusOf(0.12);
    const auto work = [&] { return extentOf(torus); };
    const Extent one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.area == two.area && one.volume == two.volume && one.triangles == two.triangles);
}

static const test::Registered<ExtentTest> registered;
#include "extent_test.moc"
