// A surface that knows its rims ends beside them and nowhere else, whichever way it is evaluated.
#include "core/surface/rims.h"

#include "core/base/random.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/evaluation/self.h"
#include "core/surface/evaluation/together.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3f;
using surface::Status, surface::Surface;

class KnownRimsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void itEndsBesideRimsOnly();
    void allWaysAgree();
    void modelsWithoutTheWordEndByTheLimit();
};

namespace {

/// A square sheet of which the rim at one side alone is known to be one.
surfel::SurfelList sheet(bool attribute = true) {
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    if (attribute)
        layout->add(surface::rimName, surfel::ScalarType::UInt8);
    surfel::SurfelList out;
    out.layout = layout;
    base::Random random(test::seed());
    constexpr float spacing = 0.05f, support = 3.5f * spacing;
    std::vector<std::uint32_t> words(layout->words());
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 20; ++k) {
            const Vec3f at{(static_cast<float>(i) + 0.5f) * spacing, (static_cast<float>(k) + 0.5f) * spacing, 0};
            const Vec3f jitter{float(random.uniform(-0.01, 0.01)), float(random.uniform(-0.01, 0.01)), 0};
            if (attribute)
                words[0] = at.x < surface::rimReach * support ? 1 : 0;
            out.append({at + jitter, {0, 0, 1}, support}, words);
        }
    return out;
}

Surface surfaceOf(const surfel::SurfelList& list, bool known) {
    surface::SurfaceDefinition definition;
    definition.boundaryLimit = 0.2f;
    definition.knownRims = known;
    return {tree::SurfelTree::build(list), definition};
}

/// Places about the sheet, beyond its four sides too.
std::vector<Vec3f> places(int count) {
    base::Random random(test::seed() + 1);
    std::vector<Vec3f> out;
    for (int i = 0; i < count; ++i)
        out.push_back(
            {float(random.uniform(-0.12, 1.12)), float(random.uniform(0.3, 0.7)), float(random.uniform(-0.01, 0.01))});
    return out;
}

} // namespace

void KnownRimsTest::itEndsBesideRimsOnly() {
    const Surface surface = surfaceOf(sheet(), true);
    QVERIFY(surface.evaluate(Vec3f{-0.08f, 0.5f, 0}).status == Status::BeyondBoundary);
    QVERIFY(surface.evaluate(Vec3f{1.08f, 0.5f, 0}).status == Status::Ok);
    QVERIFY(surface.evaluate(Vec3f{0.5f, 1.08f, 0}).status == Status::Ok);
    for (const surface::BoundaryCurve& curve : surface::findBoundaryCurves(surface))
        for (const surface::BoundaryPoint& point : curve.points)
            QVERIFY(point.position.x < 0.4);
}

void KnownRimsTest::allWaysAgree() {
    const Surface surface = surfaceOf(sheet(), true);
    const std::vector<Vec3f> x = places(2000);
    std::vector<surface::Evaluationf> batch(x.size());
    surface.evaluate(x, surface::Need::Gradient, batch);
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const surface::Evaluationf one = surface.evaluate(x[i]);
        QVERIFY2(one.status == batch[i].status, qPrintable(QString("seed %1").arg(test::seed())));
        const surface::Evaluationd reference = surface.evaluateReference(base::cast<double>(x[i]));
        const bool close = std::abs(reference.offCentre - 0.2 * reference.unit) < 1e-4 * reference.unit;
        QVERIFY(close || one.status == reference.status);
        if (!one.ok() && one.status != Status::BeyondBoundary)
            continue;
        const bool past = one.offCentre > 0.2f * one.unit;
        QCOMPARE(one.status == Status::BeyondBoundary, past && surface::mayEnd(surface, x[i]));
        beyond += one.status == Status::BeyondBoundary;
    }
    QVERIFY(beyond > 20);
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        surface::SelfEvaluator self(surface);
        surface::SelfLanes at[surfel::clustersPerBlock];
        self.evaluate(block, block.clusterMask(), surface::Need::Value, at);
        for (int slot = 0; slot < block.size(); ++slot)
            QVERIFY(at[slot / surfel::clusterSize].status[slot % surfel::clusterSize] ==
                    surface.evaluate(block.position(slot), surface::Need::Value, {block.normal(slot)}).status);
    });
}

void KnownRimsTest::modelsWithoutTheWordEndByTheLimit() {
    for (const Surface& surface : {surfaceOf(sheet(), false), surfaceOf(sheet(false), true)}) {
        QVERIFY(!surface::knowsRims(surface));
        QVERIFY(surface.evaluate(Vec3f{1.08f, 0.5f, 0}).status == Status::BeyondBoundary);
    }
}

static const test::Registered<KnownRimsTest> registered;
#include "known_rims_test.moc"
