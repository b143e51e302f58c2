#include "core/mesh/cell_size.h"

#include "core/base/random.h"
#include "core/mesh/extent/extent.h"
#include "core/mesh/marching/marching_cubes.h"
#include "core/process/estimation/prepare.h"
#include "core/process/estimation/spacing_sample.h"
#include "process/even_shapes.h"
#include "support/registry.h"

#include <QTest>

class CellSizeTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void evenModelsHaveTheirMedianSpacing();
    void aHandfulOfSurfelsIsMeshed();
    void squaresAreAtMostSoManyToASurfel();
};

/// A ball of points, `size` large.
static void addBall(surfel::SurfelList& list, std::size_t count, float size, const base::Vec3f& at) {
    for (surfel::Surfel s : test::spherePoints(count).items) {
        s.position = s.position * size + at;
        s.support *= size;
        list.append(s, {});
    }
}

void CellSizeTest::evenModelsHaveTheirMedianSpacing() {
    for (const std::size_t count : {500, 5000}) {
        const auto tree = tree::SurfelTree::build(test::spherePoints(count));
        QCOMPARE(mesh::usualCell(tree), double(process::typicalSpacing(tree)));
    }
    QCOMPARE(mesh::usualCell(tree::SurfelTree::build(surfel::SurfelList())), 0.0);
}

/// Too few to have a spacing that is sampled.
void CellSizeTest::aHandfulOfSurfelsIsMeshed() {
    for (const std::size_t count : {5, 6}) {
        const surface::Surface surface = process::prepare(test::spherePoints(count), {});
        QVERIFY(mesh::usualCell(surface.tree()) > 0);
        mesh::MarchingReport report;
        QVERIFY(!mesh::marchingCubes(surface, {}, report).triangles.empty());
        QVERIFY(mesh::extentOf(surface).area > 0);
    }
}

/// A large ball and small ones on it, of more points than it has itself.
void CellSizeTest::squaresAreAtMostSoManyToASurfel() {
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(10); ++round) {
        surfel::SurfelList list = test::spherePoints(3000);
        const auto small = static_cast<float>(std::pow(10, -random.uniform(0.5, 4)));
        const auto balls = 1 + random.below(3);
        for (std::size_t k = 0; k < balls; ++k)
            addBall(list, 4000, small, base::cast<float>(random.unitVector() * (1 + double(small))));
        const double cell = mesh::usualCell(tree::SurfelTree::build(list)), area = 4 * std::numbers::pi;
        QVERIFY2(area / (cell * cell) < 40 * double(list.size()),
                 qPrintable(QString("%1 small balls of %2: cells of %3, seed %4")
                                .arg(balls)
                                .arg(double(small))
                                .arg(cell)
                                .arg(test::seed())));
    }
}

static const test::Registered<CellSizeTest> registered;
#include "cell_size_test.moc"
