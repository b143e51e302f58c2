// Where a part of a model ends: what was closed has a rim where neighbours were parted, and none where a whole piece
// went.
#include "core/process/estimation/part_limit.h"

#include "core/base/random.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/surface/curves/boundary_curves.h"
#include "even_shapes.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using surface::Boundary;

class PartLimitTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void closedModelsEndWhereTheyWereParted();
    void wholePiecesThatGoLeaveTheRestClosed();
    void fewSurfelsEndToo();
    void limitsThatWereGivenStay();
    void whatLosesNothingStaysAsItIs();
};

namespace {

surface::Surface closed(const surfel::SurfelList& list, Boundary boundary = Boundary::None) {
    surface::SurfaceDefinition definition;
    definition.boundary = boundary;
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {tree::SurfelTree::build(list), definition};
}

/// On one side of a plane, from a tree that is built anew: nothing but places is shared.
tree::SurfelTree half(const surface::Surface& whole, const Vec3d& normal, double offset) {
    surfel::SurfelList out;
    out.layout = whole.tree().layout();
    for (const surfel::Surfel& s : whole.tree().surfels().items)
        if (dot(base::cast<double>(s.position), normal) < offset)
            out.append(s, {});
    return tree::SurfelTree::build(out);
}

} // namespace

void PartLimitTest::closedModelsEndWhereTheyWereParted() {
    base::Random random(test::seed());
    for (const Boundary boundary : {Boundary::None, Boundary::Auto}) {
        const surface::Surface whole = closed(test::spherePoints(3000), boundary);
        const surface::Surface left =
            process::partOf(whole, half(whole, random.unitVector(), random.uniform(-0.6, 0.6)));
        QVERIFY(left.definition().boundary == Boundary::Auto && std::isfinite(left.definition().boundaryLimit));
        QVERIFY2(findBoundaryCurves(left).size() == 1, qPrintable(QString("seed %1").arg(test::seed())));
    }
}

void PartLimitTest::wholePiecesThatGoLeaveTheRestClosed() {
    surfel::SurfelList both = test::spherePoints(1500);
    for (surfel::Surfel s : test::spherePoints(1500).items) {
        s.position = s.position + Vec3f{2.2f, 0, 0};
        both.append(s, {});
    }
    const surface::Surface whole = closed(both);
    const surface::Surface left = process::partOf(whole, half(whole, {1, 0, 0}, 1.1));
    QVERIFY(left.definition().boundary == Boundary::None && std::isinf(left.definition().boundaryLimit));
}

/// Which show no rim.
void PartLimitTest::fewSurfelsEndToo() {
    const surface::Surface whole = closed(test::spherePoints(80));
    const surface::Surface left = process::partOf(whole, half(whole, {0, 0, 1}, 0.1));
    QVERIFY(std::isfinite(left.definition().boundaryLimit));
}

/// Also by somebody who wants the gaps of an open surface closed.
void PartLimitTest::limitsThatWereGivenStay() {
    surface::Surface whole = closed(test::spherePoints(3000));
    whole = closed(half(whole, {0, 0, 1}, 0.2).surfels());
    QVERIFY(std::isfinite(process::automaticBoundaryLimit(whole)));
    const surface::Surface left = process::partOf(whole, half(whole, {1, 0, 0}, 0));
    QVERIFY(left.definition().boundary == Boundary::None);
    surface::SurfaceDefinition definition = whole.definition();
    definition.boundary = Boundary::Limit;
    definition.boundaryLimit = 0.22f;
    const surface::Surface limited{whole.tree(), definition};
    QCOMPARE(process::partOf(limited, half(whole, {1, 0, 0}, 0)).definition().boundaryLimit, 0.22f);
}

void PartLimitTest::whatLosesNothingStaysAsItIs() {
    const surface::Surface whole = closed(test::spherePoints(1000));
    QVERIFY(process::partOf(whole, whole.tree()).definition() == whole.definition());
    QVERIFY(process::partOf(whole, half(whole, {1, 0, 0}, 2)).definition() == whole.definition());
}

static const test::Registered<PartLimitTest> registered;
#include "part_limit_test.moc"
