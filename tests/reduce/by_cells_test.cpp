// Reduced sets of models with cells: edges stay where they are, every cell keeps its share, counts are exact.
#include "core/reduce/by_cells.h"

#include "cells/solids.h"
#include "core/cells/cell_rays.h"
#include "core/cells/seams.h"
#include "core/reduce/counts.h"
#include "support/registry.h"
#include "support/sanitized.h"

#include <QTest>

#include <numeric>

using namespace reduce;
using base::Vec3d;

class ByCellsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void partsAreExactAndWithinTheirBounds();
    void edgesStayWhereTheyAre_data();
    void edgesStayWhereTheyAre();
    void anErrorIsKeptByEveryCell();
    void countsThatLoseEdgesAreRefused();
};

void ByCellsTest::partsAreExactAndWithinTheirBounds() {
    base::Random random(test::seed());
    for (int round = 0; round < 2000; ++round) {
        const auto n = static_cast<std::size_t>(random.uniform(1, 30));
        std::vector<double> weights;
        std::vector<std::size_t> least, most;
        for (std::size_t i = 0; i < n; ++i) {
            weights.push_back(std::pow(10, random.uniform(-30, 6)));
            least.push_back(static_cast<std::size_t>(random.uniform(0, 20)));
            most.push_back(least.back() + static_cast<std::size_t>(random.uniform(0, 1000)));
        }
        const auto low = std::accumulate(least.begin(), least.end(), std::size_t(0));
        const auto high = std::accumulate(most.begin(), most.end(), std::size_t(0));
        const std::size_t total = low + static_cast<std::size_t>(random.uniform(0, 1) * double(high - low));
        const std::vector<std::size_t> parts = apportion(weights, least, most, total);
        QCOMPARE(std::accumulate(parts.begin(), parts.end(), std::size_t(0)), total);
        for (std::size_t i = 0; i < n; ++i)
            QVERIFY(parts[i] >= least[i] && parts[i] <= most[i]);
    }
}

void ByCellsTest::edgesStayWhereTheyAre_data() {
    QTest::addColumn<int>("solid");
    QTest::addRow("cube") << 0;
    QTest::addRow("L") << 1;
    QTest::addRow("pyramid") << 2;
}

/// Rays about the edges meet the solid where its planes say; seams are as long as before.
void ByCellsTest::edgesStayWhereTheyAre() {
    QFETCH(int, solid);
    base::Random random(test::seed());
    const double spacing = test::sanitized ? 0.06 : 0.04;
    const plane_solids::Solid exact = solid == 0   ? plane_solids::cube(0.5)
                                      : solid == 1 ? plane_solids::lBlock(0.6)
                                                   : plane_solids::pyramid(5, 0.7, 0.9);
    const surfel::SurfelList list = plane_solids::sampled(exact, 2, spacing, random).surfels;
    const surface::Surface model = plane_solids::surfaceOf(list);
    const std::size_t count = list.size() / 5;
    const Reduced reduced = reduceBy(model, {count, 0, 0, Shapes::Auto});
    QCOMPARE(reduced.surface.tree().size(), count);
    QCOMPARE(reduced.report.count, count);
    QCOMPARE(reduced.report.holes, std::size_t(0));
    const auto cells = cells::CellSurface::of(reduced.surface);
    QVERIFY(cells);
    const auto seamsOf = [](const cells::CellSurface& surface) {
        double out = 0;
        for (const cells::Seam& seam : cells::traceSeams(surface))
            out += seam.length();
        return out;
    };
    const double before = seamsOf(*cells::CellSurface::of(model)), after = seamsOf(*cells);
    // curves end up to a spacing before their corners, and spacings are twice as wide
    QVERIFY2(std::abs(after / before - 1) < 0.06, QByteArray::number(after / before));

    std::vector<base::Rayf> rays;
    std::vector<double> expected;
    while (rays.size() < 400) {
        const Vec3d from = random.unitVector() * 3,
                    to{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.9)};
        const base::Rayd ray{from, normalized(to - from)};
        std::size_t plane = 0;
        const double t = exact.hit(ray, plane);
        const Vec3d x = ray.at(t);
        int near = 0; // planes: two are an edge
        for (const plane_solids::Plane& each : exact.planes)
            near += std::abs(each.f(x)) < 2 * spacing;
        if (t > 0 && near > 1 && std::abs(dot(exact.planes[plane].n, ray.direction)) > 0.3) {
            rays.push_back({base::cast<float>(ray.origin), base::cast<float>(ray.direction)});
            expected.push_back(t);
        }
    }
    std::vector<surface::RayHit<float>> hits(rays.size());
    cells::intersect(*cells, rays, {}, hits);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
        wrong += !(hits[i].hit && std::abs(double(hits[i].t) - expected[i]) < 0.02 * spacing);
    QVERIFY2(wrong <= rays.size() / 100, QByteArray::number(int(wrong)));
}

/// Flat cells need next to nothing: a tenth is plenty.
void ByCellsTest::anErrorIsKeptByEveryCell() {
    base::Random random(test::seed());
    const double spacing = 0.08;
    const surface::Surface model =
        plane_solids::surfaceOf(plane_solids::sampled(plane_solids::cube(0.5), 2, spacing, random).surfels);
    const Reduced reduced = reduceBy(model, {0, 0, 0.01 * spacing, Shapes::Spheres});
    QVERIFY(reduced.surface.tree().size() < model.tree().size() / 4);
    QVERIFY(reduced.report.rms <= 0.01 * spacing);
    QCOMPARE(cells::CellSurface::of(reduced.surface).has_value(), true);
}

void ByCellsTest::countsThatLoseEdgesAreRefused() {
    base::Random random(test::seed());
    const surface::Surface model =
        plane_solids::surfaceOf(plane_solids::sampled(plane_solids::cube(0.5), 2, 0.1, random).surfels);
    QString said;
    try {
        reduceBy(model, {20, 0, 0, Shapes::Spheres});
    } catch (const base::Error& error) {
        said = error.what();
    }
    QVERIFY2(said.contains("6 cells"), qPrintable(said));
}

static const test::Registered<ByCellsTest> registered;
#include "by_cells_test.moc"
