// All ways to the same evaluation: alone, in batches, by steps, on scaled supports, by the short way and by the
// reference.
#include "core/surface/definition_text.h"
#include "core/surface/evaluation/assemble.h"
#include "core/surface/evaluation/summed_normals.h"
#include "support/registry.h"
#include "surface/shapes.h"

#include <QTest>

using namespace surface;
using base::Vec3f;
using shapes::sameBits;

class EvaluationWaysTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void singleBatchAndScatteredGiveTheSameBits();
    void wideSupportsAndFarPositionsChangeNoBits();
    void oneWideSupportLeavesListsShort();
    void supportScaleReachesAllSurfels();
    void hessiansFollowTheReference();
    void shortWayGivesTheNumbersOfTheAssembler();
};

static bool same(const Evaluationf& a, const Evaluationf& b) {
    return a.status == b.status && a.samples == b.samples && sameBits(a.value, b.value) &&
           sameBits(a.weight, b.weight) && sameBits(a.centroid, b.centroid) && sameBits(a.normal, b.normal) &&
           sameBits(a.gradient, b.gradient) && sameBits(a.hessian, b.hessian) && sameBits(a.unit, b.unit) &&
           sameBits(a.normalGradient, b.normalGradient) && sameBits(a.agreement, b.agreement);
}

void EvaluationWaysTest::singleBatchAndScatteredGiveTheSameBits() {
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.03, 0.1), 0.005, test::seed());
    for (const float scale : {1.0f, 1.5f}) {
        const Surface surface = shapes::surfaceOf(list).withSupportScale(scale);
        std::vector<Vec3f> coherent;
        const auto inOrder = surface.tree().surfels();
        for (const surfel::Surfel& s : inOrder.items)
            coherent.push_back(s.position + base::cast<float>(random.unitVector() * 0.05));
        std::vector<Vec3f> scattered = coherent;
        std::vector<std::size_t> from(coherent.size());
        for (std::size_t i = 0; i < from.size(); ++i)
            from[i] = i;
        for (std::size_t i = from.size() - 1; i > 0; --i) {
            const std::size_t j = random.below(i + 1);
            std::swap(from[i], from[j]), std::swap(scattered[i], scattered[j]);
        }
        for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
            std::vector<Evaluationf> a(coherent.size()), b(coherent.size());
            surface.evaluate(coherent, need, a);
            surface.evaluate(scattered, need, b);
            Source close(surface);
            for (std::size_t i = 0; i < a.size(); ++i) {
                QVERIFY(same(a[from[i]], b[i]));
                if (i % 7 != 0)
                    continue;
                QVERIFY(same(a[i], surface.evaluate(coherent[i], need)));
                for (int step = 0; step < 3; ++step) {
                    const Vec3f x = coherent[i] + base::cast<float>(random.unitVector() * 0.02);
                    QVERIFY(same(close.evaluate(x, need), surface.evaluate(x, need)));
                }
            }
        }
    }
}

/// A torus with one support of 30 times the others.
static surfel::SurfelList withOneWideSupport() {
    surfel::SurfelList out = shapes::jittered(shapes::torus(1, 0.4, 0.03, 0.1), 0.005, test::seed());
    out.items[out.size() / 3].support *= 30;
    return out;
}

void EvaluationWaysTest::wideSupportsAndFarPositionsChangeNoBits() {
    base::Random random(test::seed());
    const Surface surface = shapes::surfaceOf(withOneWideSupport());
    std::vector<Vec3f> x;
    for (int i = 0; i < 3000; ++i)
        x.push_back(base::cast<float>(random.unitVector() * random.uniform(0.5, 1.5)));
    for (std::size_t i = 0; i < x.size(); i += 500) // their grid has one cell for all the others
        x[i] = base::cast<float>(random.unitVector() * 1e9);
    x[1] = x[2] = {std::numeric_limits<float>::infinity(), 0, 0};
    std::vector<Evaluationf> batch(x.size());
    surface.evaluate(x, Need::Gradient, batch);
    for (std::size_t i = 0; i < x.size(); ++i)
        QVERIFY2(same(batch[i], surface.evaluate(x[i], Need::Gradient)),
                 qPrintable(QString("%1, seed %2").arg(i).arg(test::seed())));
}

/// What a packet collects follows the supports where it lies: not the widest of the model, and not its whole.
void EvaluationWaysTest::oneWideSupportLeavesListsShort() {
    const Surface surface = shapes::surfaceOf(withOneWideSupport());
    const surfel::BlockPtr block = surface.tree().block(0);
    const Vec3f here = block->position(0);
    const float usual = block->support(0);
    Source source(surface);
    QVERIFY(source.expect(base::Box3f{here, here}.inflated(0.1f * usual), 0.3f, 32));
    QVERIFY(source.covers(here + Vec3f{0.3f * usual, 0, 0}));
    QVERIFY(!source.covers(here + Vec3f{0.6f * usual, 0, 0}));
    QVERIFY(!source.expect(surface.tree().bounds(), 0, 32));
    QVERIFY(!source.covers(here));
    QVERIFY(source.expect(surface.tree().bounds(), 0.3f, 1)); // one position is worth all that it needs
    QVERIFY(source.covers(here));
}

void EvaluationWaysTest::supportScaleReachesAllSurfels() {
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.05, 0.12), 0.01, test::seed());
    surfel::SurfelList larger = list;
    for (surfel::Surfel& s : larger.items)
        s.support *= 2;
    const Surface scaled = shapes::surfaceOf(list).withSupportScale(2), plain = shapes::surfaceOf(larger);
    Source source(scaled);
    for (int i = 0; i < test::effort(300); ++i) {
        const Vec3f x = shapes::beside(list, random, 0.2);
        const Evaluationf a = scaled.evaluate(x), b = plain.evaluate(x);
        QCOMPARE(a.samples, b.samples);
        QVERIFY(same(a, b)); // twice the support is exact, and the tree's order follows positions alone
        QVERIFY(same(a, source.evaluate(x, Need::Gradient)));
    }
}

void EvaluationWaysTest::hessiansFollowTheReference() {
    base::Random random(test::seed());
    for (const auto& weight : weightNames()) {
        const double support = weight.value == Weight::Gaussian ? 0.6 : 0.36;
        const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, support), 0.005, test::seed());
        SurfaceDefinition definition;
        definition.weight = weight.value;
        const Surface surface = shapes::surfaceOf(list, definition);
        for (int i = 0; i < test::effort(200); ++i) {
            const Vec3f x = shapes::beside(list, random, 0.1);
            const Evaluationf f = surface.evaluate(x, Need::Hessian);
            const Evaluationd d = surface.evaluateReference(base::cast<double>(x), Need::Hessian);
            QCOMPARE(f.status, d.status);
            if (d.status != Status::Ok)
                continue;
            QVERIFY(distance(base::cast<double>(f.gradient), d.gradient) <= 1e-4);
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l)
                    QVERIFY2(
                        std::abs(static_cast<double>(f.hessian[k][l]) - d.hessian[k][l]) * d.unit <= 2e-3,
                        qPrintable(QString("%1: %2 %3").arg(weight.name).arg(f.hessian[k][l]).arg(d.hessian[k][l])));
        }
    }
}

/// Largest difference of two answers' numbers, in units of h where they are lengths, relative where derivatives.
static float difference(const Evaluationf& a, const Evaluationf& b) {
    float out = std::max({std::abs(a.value - b.value), distance(a.centroid, b.centroid), std::abs(a.unit - b.unit),
                          std::abs(a.offCentre - b.offCentre)}) /
                b.unit;
    out = std::max({out, distance(a.normal, b.normal), std::abs(a.agreement - b.agreement),
                    distance(a.gradient, b.gradient), std::abs(a.weight - b.weight) / b.weight});
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
            out = std::max({out, std::abs(a.normalGradient[k][l] - b.normalGradient[k][l]) * b.unit,
                            std::abs(a.hessian[k][l] - b.hessian[k][l]) * b.unit});
    return out;
}

void EvaluationWaysTest::shortWayGivesTheNumbersOfTheAssembler() {
    base::Random random(test::seed());
    const surfel::SurfelList list = shapes::jittered(shapes::torus(1, 0.4, 0.06, 0.21), 0.01, test::seed());
    for (const bool shrinkFree : {true, false})
        for (const float limit : {0.1f, std::numeric_limits<float>::infinity()}) {
            SurfaceDefinition definition = shapes::definitionOf(Frame::Normals, shrinkFree);
            definition.boundaryLimit = limit;
            const Surface surface = shapes::surfaceOf(list, definition);
            const SummedNormals shortWay(surface);
            QVERIFY(shortWay.applies());
            const Source source(surface);
            int taken = 0;
            const int tries = test::effort(400);
            for (int i = 0; i < tries; ++i) {
                const Vec3f x = shapes::beside(list, random, 0.2);
                const ScratchClusters clusters(surface.tree(), x);
                for (const Need need : {Need::Value, Need::Gradient, Need::Hessian}) {
                    Evaluationf found;
                    if (!shortWay.evaluate(clusters.span(), x, need, found))
                        continue;
                    ++taken;
                    const Evaluationf expected =
                        need == Need::Value      ? Assembler<float, 0>(source, clusters.span(), x, {}).run()
                        : need == Need::Gradient ? Assembler<float, 1>(source, clusters.span(), x, {}).run()
                                                 : Assembler<float, 2>(source, clusters.span(), x, {}).run();
                    QVERIFY(found.status == expected.status && found.cause == expected.cause);
                    QCOMPARE(found.samples, expected.samples);
                    QVERIFY2(difference(found, expected) <= 1e-5f,
                             qPrintable(QString::number(difference(found, expected))));
                }
            }
            QVERIFY(2 * taken > 3 * tries);
        }
}

static const test::Registered<EvaluationWaysTest> registered;
#include "evaluation_ways_test.moc"
