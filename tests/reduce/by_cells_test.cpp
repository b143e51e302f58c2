// Reduced sets of models with cells: edges stay where they are, every cell keeps its share, counts are exact.
#include "core/reduce/by_cells.h"

#include "cells/solids.h"
#include "core/cells/cell_rays.h"
#include "core/cells/seams.h"
#include "core/reduce/counts.h"
#include "core/reduce/refine.h"
#include "reduce/creased_rays.h"
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
    void anyModelKeepsItsEdges_data();
    void anyModelKeepsItsEdges();
    void cellsWithoutASurfaceAreThinned();
    void anErrorIsThatOfAllCells();
    void farFromTheOriginAndWithMoreToCarry();
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

void ByCellsTest::anyModelKeepsItsEdges_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("uneven");
    int k = 0;
    for (const char* name : {"cylinder", "cylinders that cross", "lens", "box with a ball and a hole", "small bosses",
                             "gear", "acute wedge", "thin plate"}) {
        if (!test::sanitized || k == 3 || k == 6) // minutes each there
            QTest::newRow(name) << k << 1.0;
        ++k;
    }
    QTest::newRow("uneven cylinder") << 0 << 20.0;
}

static creased::Model creasedModel(int kind, double spacing) {
    switch (kind) {
    case 0:
        return creased::cappedCylinder();
    case 1:
        return creased::cross();
    case 2:
        return creased::lens();
    case 3:
        return creased::boxWithBallAndHole();
    case 4:
        return creased::bosses(2 * spacing, 6);
    case 5:
        return creased::gear(11);
    case 6:
        return creased::wedge(15);
    default:
        return creased::box(0.8, 0.8, spacing);
    }
}

/// Rays meet a tenth of the samples where they meet the solid, and the same made dense again. Flat cells beside round
/// ones have supports several times as large, and tiny ones fewer samples than edges.
void ByCellsTest::anyModelKeepsItsEdges() {
    QFETCH(int, kind);
    QFETCH(double, uneven);
    base::Random random(test::seed());
    const double s = test::sanitized ? 0.06 : 0.04, least = uneven > 1 ? s / 4 : s;
    const creased::Model model = creasedModel(kind, s);
    const creased::Spacing spacing = [&](const Vec3d& x) {
        return least * std::pow(uneven, std::clamp((x.x + 0.6) / 1.2, 0.0, 1.0));
    };
    const surfel::SurfelList list = creased::sampled(model, spacing, least, random);
    const surface::Surface dense = creased::surfaceOf(list);
    const creased::Truth truth = creased::truthOf(model, list, spacing, 3000, random);
    const std::size_t count = list.size() / (test::sanitized ? 5 : 10);
    const Reduced reduced = reduceBy(dense, {count, 0, 0, Shapes::Spheres});
    QCOMPARE(reduced.surface.tree().size(), count);
    QCOMPARE(reduced.report.count, count);
    QCOMPARE(reduced.report.picked, std::size_t(0));
    const auto judge = [&](const surface::Surface& surface) { return creased::judged(surface, truth, 0.3); };
    const creased::Judged before = judge(dense), after = judge(reduced.surface);
    const auto told = [&](const creased::Judged& is) {
        return QString("seed %1: %2 lost, %3 early, %4 off of %5 rays, rms %6; dense %7 wrong, rms %8")
            .arg(test::seed())
            .arg(is.lost)
            .arg(is.early)
            .arg(is.off)
            .arg(truth.rays.size())
            .arg(is.rms)
            .arg(before.wrong())
            .arg(before.rms)
            .toUtf8();
    };
    QVERIFY2(after.wrong() <= before.wrong() + 5, told(after));
    QVERIFY2(after.rms < before.rms + 0.02, told(after));
    if (uneven > 1)
        return;
    const Refined again = refine(reduced.surface, static_cast<float>(s));
    const creased::Judged refined = judge(again.surface);
    QVERIFY2(std::abs(double(again.report.count) / double(list.size()) - 1) < 0.4,
             QByteArray::number(int(again.report.count)));
    QVERIFY2(refined.wrong() <= before.wrong() + 5 && refined.rms < before.rms + 0.03, told(refined));
}

/// One face of a cube whose surfels have no normals: the count is exact all the same, and that is said.
void ByCellsTest::cellsWithoutASurfaceAreThinned() {
    base::Random random(test::seed());
    surfel::SurfelList list = plane_solids::sampled(plane_solids::cube(0.5), 2, 0.06, random).surfels;
    const auto labels = *cells::LabelLayout::of(*list.layout);
    for (std::size_t i = 0; i < list.size(); ++i)
        if (labels.at(list.extraOf(i)).cell == 4)
            list.items[i].normal = {};
    const std::size_t count = list.size() / 6;
    const Reduced reduced = reduceBy(plane_solids::surfaceOf(list), {count, 0, 0, Shapes::Spheres});
    QCOMPARE(reduced.surface.tree().size(), count);
    QCOMPARE(reduced.report.count, count);
    QVERIFY(reduced.report.picked > 0 && reduced.report.picked < count / 2);
    QVERIFY(QByteArray(summaryOf(reduced.report).c_str()).contains("the model's own"));
}

/// A rough cell that stays whole has its part in the error; what is left is for the others.
void ByCellsTest::anErrorIsThatOfAllCells() {
    base::Random random(test::seed());
    surfel::SurfelList list = plane_solids::sampled(plane_solids::cube(0.5), 2, 0.06, random).surfels;
    const auto labels = *cells::LabelLayout::of(*list.layout);
    for (std::size_t i = 0; i < list.size(); ++i)
        if (labels.at(list.extraOf(i)).cell == 4)
            list.items[i].position.z += static_cast<float>(0.01 * random.normal());
    const surface::Surface model = plane_solids::surfaceOf(list);
    // of a sixth of the samples .01 and a bit less is .004 of all
    const Reduced reduced = reduceBy(model, {0, 0, 0.0045, Shapes::Spheres});
    QVERIFY(reduced.report.rms <= 0.0045 && reduced.report.rms > 0.002);
    QVERIFY(reduced.surface.tree().size() < list.size() / 2);
    QVERIFY_THROWS_EXCEPTION(base::Error, reduceBy(model, {0, 0, 0.002, Shapes::Spheres}));
}

/// Coordinates lose digits far out, and colours and numbers come along within their own cells.
void ByCellsTest::farFromTheOriginAndWithMoreToCarry() {
    base::Random random(test::seed());
    surfel::SurfelList list = plane_solids::sampled(plane_solids::cube(0.5), 2, 0.05, random).surfels;
    const auto labels = *cells::LabelLayout::of(*list.layout);
    auto layout = std::make_shared<surfel::AttributeLayout>(*list.layout);
    layout->colours = true;
    list.layout = layout;
    for (std::size_t i = 0; i < list.size(); ++i) {
        list.items[i].colour = labels.at(list.extraOf(i)).cell % 2 == 0 ? 0xff0000ffu : 0xff00ff00u;
        list.items[i].position += base::Vec3f{100, -50, 20};
    }
    const std::size_t count = list.size() / 8;
    const Reduced reduced = reduceBy(plane_solids::surfaceOf(list), {count, 0, 0, Shapes::Spheres});
    QCOMPARE(reduced.surface.tree().size(), count);
    QCOMPARE(reduced.report.holes, std::size_t(0));
    const surfel::SurfelList few = reduced.surface.tree().surfels();
    const auto own = *cells::LabelLayout::of(*few.layout);
    for (std::size_t i = 0; i < few.size(); ++i)
        QCOMPARE(few.items[i].colour, own.at(few.extraOf(i)).cell % 2 == 0 ? 0xff0000ffu : 0xff00ff00u);
}

static const test::Registered<ByCellsTest> registered;
#include "by_cells_test.moc"
