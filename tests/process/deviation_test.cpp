// Distances from surfels to another surface: with sign, exact, whatever the origins; what lies beyond it is told apart.
#include "core/process/measuring/deviation.h"

#include "core/process/estimation/prepare.h"
#include "process/even_shapes.h"
#include "support/registry.h"
#include "support/threads.h"

#include <QTest>

using namespace process;
using base::Vec3d, base::Vec3f;

class DeviationTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void concentricSpheresAreTheirRadiiApart();
    void theSignFollowsTheNormals();
    void originsAreTakenOff();
    void whatIsBeyondTheBoundaryIsCounted();
    void threadsDoNotShow();
};

static surfel::SurfelList scaledSphere(std::size_t count, float radius) {
    surfel::SurfelList out = test::spherePoints(count);
    for (surfel::Surfel& s : out.items)
        s.position = s.position * radius, s.support *= radius;
    return out;
}

void DeviationTest::concentricSpheresAreTheirRadiiApart() {
    const surface::Surface unit = test::surfaceOf(test::spherePoints(6000));
    for (const float radius : {0.9f, 1.05f, 1.5f}) {
        const DeviationFigures d = deviationOf(tree::SurfelTree::build(scaledSphere(500, radius)), unit, {});
        QCOMPARE(d.count, std::size_t(500));
        QCOMPARE(d.beyond + d.lost, std::size_t(0));
        const double off = double(radius) - 1; // the surface of 6000 points is a sphere to 1e-5
        QVERIFY2(std::abs(d.mean - off) < 2e-5 && std::abs(d.rms - std::abs(off)) < 2e-5,
                 qPrintable(QString::number(d.mean - off)));
        QVERIFY(std::abs(d.max - std::abs(off)) < 1e-4 && std::abs(d.p99 - std::abs(off)) < 1e-4);
    }
}

void DeviationTest::theSignFollowsTheNormals() {
    surfel::SurfelList inwards = test::spherePoints(3000);
    for (surfel::Surfel& s : inwards.items)
        s.normal = -s.normal;
    const tree::SurfelTree larger = tree::SurfelTree::build(scaledSphere(300, 1.1f));
    QVERIFY(std::abs(deviationOf(larger, test::surfaceOf(inwards), {}).mean + 0.1) < 1e-3);
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = true;
    inwards.layout = layout;
    const DeviationFigures d = deviationOf(larger, test::surfaceOf(inwards), {});
    QVERIFY(!d.sided && std::abs(d.mean - 0.1) < 1e-3);
}

void DeviationTest::originsAreTakenOff() {
    const surface::Surface unit = test::surfaceOf(test::spherePoints(4000));
    surfel::SurfelList moved = test::spherePoints(400);
    const Vec3d shift{1e7 + 0.25, -3e6, 0.125};
    for (surfel::Surfel& s : moved.items)
        s.position += Vec3f{0.25f, 0, 0.125f}; // 0.25 and 0.125 of what its origin says otherwise
    const Vec3d between = Vec3d{1e7, -3e6, 0} - shift;
    const DeviationFigures d = deviationOf(tree::SurfelTree::build(moved), unit, between);
    QVERIFY2(d.rms < 1e-4 && d.count == 400, qPrintable(QString::number(d.rms)));
}

void DeviationTest::whatIsBeyondTheBoundaryIsCounted() {
    surfel::SurfelList small = test::planePoints(30, 0.02), large = test::planePoints(60, 0.02);
    for (surfel::Surfel& s : large.items)
        s.position.z += 0.01f;
    const surface::Surface sheet = prepare(small, {});
    QVERIFY(std::isfinite(sheet.definition().boundaryLimit));
    const DeviationFigures d = deviationOf(tree::SurfelTree::build(large), sheet, {});
    QCOMPARE(d.count + d.beyond + d.lost, large.size());
    // a quarter of the large sheet lies over the small one, but for its rim
    QVERIFY2(std::abs(double(d.count) / double(large.size()) - 0.25) < 0.04, qPrintable(QString::number(d.count)));
    QVERIFY2(
        d.beyond > d.count && std::abs(d.mean - 0.01) < 1e-5 && d.max < 0.0101,
        qPrintable(QString("%1 beyond, %2 lost, %3 mean, %4 max").arg(d.beyond).arg(d.lost).arg(d.mean).arg(d.max)));
}

void DeviationTest::threadsDoNotShow() {
    const surface::Surface unit = test::surfaceOf(test::spherePoints(2000));
    const tree::SurfelTree from = tree::SurfelTree::build(scaledSphere(3000, 1.02f));
    const auto work = [&] { return deviationOf(from, unit, {}); };
    const DeviationFigures one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one.rms == two.rms && one.mean == two.mean && one.max == two.max && one.count == two.count);
}

static const test::Registered<DeviationTest> registered;
#include "deviation_test.moc"
