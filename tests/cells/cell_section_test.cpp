// Sections of solids of planes: polygons, with the corners that the planes have, and smooth models cut as ever.
#include "core/cells/cell_section.h"

#include "cells/solids.h"
#include "support/registry.h"

#include <QTest>

using namespace plane_solids;
using base::Random;

class CellSectionTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void sectionsOfCubesAreSquares();
    void sectionsOfPolyhedraAreTheirPolygons();
    void withoutCellsItIsTheSmoothSection();
};

void CellSectionTest::sectionsOfCubesAreSquares() {
    Random random(test::seed());
    const SampledSolid solid = sampled(cube(1), 2, 0.08, random);
    const base::Plane plane{{0, 0, 1}, 0.3};
    const auto curves = cells::findSection(surfaceOf(solid.surfels), plane);
    QCOMPARE(curves.size(), std::size_t(1));
    QVERIFY(curves[0].closed);
    QVERIFY(std::abs(curves[0].area(plane) - 4) < 1e-5);
    QVERIFY(std::abs(curves[0].length() - 8) < 1e-5);
    for (const double x : {-1.0, 1.0}) // every corner is a point of the curve
        for (const double y : {-1.0, 1.0})
            QVERIFY(std::any_of(curves[0].points.begin(), curves[0].points.end(), [&](const auto& p) {
                return base::distance(p.position, Vec3d{x, y, 0.3}) < 1e-5;
            }));
}

/// By any plane: one closed curve, on the solid's boundary, along which the local Boolean turns at its edges alone.
void CellSectionTest::sectionsOfPolyhedraAreTheirPolygons() {
    for (int k = 0; k < test::effort(6); ++k) {
        const std::uint64_t seed = test::seed() + static_cast<std::uint64_t>(k);
        Random random(seed);
        const SampledSolid solid = sampled(polyhedron(random), 3, 0.06, random);
        const base::Plane plane{base::normalized(Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), 0.7}),
                                random.uniform(-0.2, 0.2)};
        const QByteArray told = "seed " + QByteArray::number(static_cast<qulonglong>(seed));
        const auto curves = cells::findSection(surfaceOf(solid.surfels), plane);
        QVERIFY2(curves.size() == 1 && curves[0].closed, told);
        for (const auto& p : curves[0].points) {
            QVERIFY2(std::abs(solid.solid.value(p.position)) < 1e-5, told);
            QVERIFY2(std::abs(plane.distance(p.position)) < 1e-9, told);
        }
        // the polygon by its corners: where two planes of the solid and this one meet
        double area = 0;
        const Vec3d u = base::perpendicular(plane.normal), v = cross(plane.normal, u);
        std::vector<std::pair<double, Vec3d>> corners;
        for (std::size_t i = 0; i < solid.solid.planes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Plane &a = solid.solid.planes[i], &b = solid.solid.planes[j];
                const Vec3d way = cross(a.n, b.n);
                const double det = dot(plane.normal, way);
                if (std::abs(det) < 1e-9)
                    continue;
                const double height = plane.distance(Vec3d()); // of the origin
                const Vec3d x = (cross(b.n, plane.normal) * a.d + cross(plane.normal, a.n) * b.d - way * height) / det;
                if (solid.solid.value(x) < 1e-9)
                    corners.emplace_back(std::atan2(dot(x, v), dot(x, u)), x);
            }
        std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t i = 0; i < corners.size(); ++i)
            area += 0.5 * dot(cross(corners[i].second, corners[(i + 1) % corners.size()].second), plane.normal);
        QVERIFY2(std::abs(curves[0].area(plane) - area) < 1e-4, told + QByteArray::number(area));
    }
}

void CellSectionTest::withoutCellsItIsTheSmoothSection() {
    Random random(test::seed());
    SampledSolid solid = sampled(cube(1), 2, 0.15, random);
    solid.surfels.extra.clear();
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    solid.surfels.layout = layout;
    const surface::Surface surface = surfaceOf(solid.surfels);
    const base::Plane plane{{0, 0, 1}, 0.3};
    const auto here = cells::findSection(surface, plane), plain = surface::findSection(surface, plane);
    QCOMPARE(here.size(), plain.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        QCOMPARE(here[i].points.size(), plain[i].points.size());
        for (std::size_t k = 0; k < here[i].points.size(); ++k)
            QVERIFY(here[i].points[k].position == plain[i].points[k].position);
    }
}

static const test::Registered<CellSectionTest> registered;
#include "cell_section_test.moc"
