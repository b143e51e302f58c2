// What layers show, surfel by surfel: the kernel against the plain formulas, and changes that go into a layer.
#include "core/base/random.h"
#include "core/layers/layer_edits.h"
#include "core/layers/shown_cluster.h"
#include "core/layers/surfel_layers.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d;
using layers::SurfelLayers;

class ShownTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void kernelIsThePlainFormula();
    void whatIsRecordedIsShown();
    void aMovedBaseTakesItsLayersAlong();
    void whatIsLongMovesSidewaysNoFarther();
    void turnsAreUndoneByTheirReverse();
};

namespace {

constexpr std::uint64_t seed = 20261123;

/// A block of random words of three layers.
struct RandomBlock {
    layers::Stack stack;
    layers::Channels channels;
    surfel::MutableBlockPtr block;
    std::vector<float> weights;

    explicit RandomBlock(base::Random& random, int size = 100) {
        surfel::SurfelList points;
        auto layout = std::make_shared<surfel::AttributeLayout>();
        layout->normals = layout->oriented = true;
        points.layout = layout;
        for (int i = 0; i < size; ++i)
            points.append({base::cast<float>(random.unitVector() * 3), base::cast<float>(random.unitVector()), 0.2f},
                          {});
        tree::SurfelTree tree = tree::SurfelTree::build(points);
        for (const char* name : {"a", "b", "c"}) {
            const layers::Stack before = stack;
            stack.add(name);
            tree = layers::withWords(tree, before, stack.layers.back().id);
        }
        for (layers::Layer& each : stack.layers)
            each.strength = static_cast<float>(random.uniform() * 3 - 1);
        channels = *layers::Channels::of(*tree.layout(), stack);
        weights = layers::weightsOf(stack);
        block = tree.block(0)->clone();
        SurfelLayers words;
        for (int slot = 0; slot < block->size(); ++slot) {
            words.read(*block, slot, channels);
            for (SurfelLayers::Part& part : words.parts)
                part = {random.unitVector() * 0.3, random.unitVector() * random.uniform() * 0.6,
                        random.uniform() < 0.5 ? 0.0 : random.uniform(),
                        random.uniform() < 0.5 ? 0.0 : random.uniform()};
            words.write(*block, slot, channels);
        }
    }
};

} // namespace

void ShownTest::kernelIsThePlainFormula() {
    base::Random random(seed);
    for (int round = 0; round < 20; ++round) {
        const RandomBlock r(random);
        SurfelLayers words;
        layers::ShownCluster shown;
        for (int slot = 0; slot < r.block->size(); ++slot) {
            const int cluster = slot / surfel::clusterSize, lane = slot % surfel::clusterSize;
            layers::show(*r.block, cluster, r.channels, r.weights, shown);
            words.read(*r.block, slot, r.channels);
            const SurfelLayers::Shown expected = words.shown(r.weights);
            for (int k = 0; k < 3; ++k) {
                QVERIFY(std::abs(double(shown.position[k][lane]) - expected.position[std::size_t(k)]) < 1e-5);
                QVERIFY(std::abs(double(shown.normal[k][lane]) - expected.normal[std::size_t(k)]) < 1e-4);
            }
            QVERIFY(std::abs(double(shown.support[lane]) / expected.support - 1) < 1e-5);
        }
    }
}

/// Into any layer, whatever lies below and above it.
void ShownTest::whatIsRecordedIsShown() {
    base::Random random(seed);
    for (int round = 0; round < 20; ++round) {
        RandomBlock r(random);
        for (float& weight : r.weights)
            weight = std::copysign(std::max(std::abs(weight), 0.2f), weight);
        SurfelLayers words;
        for (int slot = 0; slot < r.block->size(); ++slot) {
            words.read(*r.block, slot, r.channels);
            for (SurfelLayers::Part& part : words.parts)
                part.mask = 0;
            SurfelLayers::Shown wanted = words.shown(r.weights);
            wanted.position += random.unitVector() * 0.1;
            wanted.normal = normalized(wanted.normal + random.unitVector() * 0.3);
            wanted.support *= 1.1;
            const int target = slot % 4 - 1;
            if (target >= 0)
                words.record(r.weights, target, wanted);
            else
                words.rebase(r.weights, wanted, slot % 8 == 0);
            const SurfelLayers::Shown now = words.shown(r.weights);
            QVERIFY2(distance(now.position, wanted.position) < 1e-6,
                     qPrintable(QString("seed %1, target %2").arg(seed).arg(target)));
            QVERIFY(dot(now.normal, wanted.normal) > 1 - 1e-6);
            QVERIFY(std::abs(now.support / wanted.support - 1) < 1e-5);
        }
    }
}

/// Turned as a whole, what is shown turns as a whole, if it is no longer than the limit.
void ShownTest::aMovedBaseTakesItsLayersAlong() {
    base::Random random(seed);
    const RandomBlock r(random);
    SurfelLayers words;
    for (int slot = 0; slot < r.block->size(); ++slot) {
        words.read(*r.block, slot, r.channels);
        for (SurfelLayers::Part& part : words.parts)
            part.d = normalized(part.d) * (random.uniform() * double(layers::leanLimit) * words.support);
        const std::vector<float> none(r.weights.size(), 0.0f);
        const SurfelLayers::Shown before = words.shown(r.weights);
        const Vec3d old = words.normal, next = normalized(old + random.unitVector() * 0.4), from = words.base;
        words.rebase(none, {from, next, words.support}, true);
        const SurfelLayers::Shown after = words.shown(r.weights);
        QVERIFY(distance(after.position - from, layers::turned(before.position - from, old, next)) < 1e-6);
        QVERIFY(distance(after.normal, layers::turned(before.normal, old, next)) < 1e-6);
    }
}

/// However far a layer moves a surfel: where the surface below turns by t, it goes sideways by no more than twice the
/// limit and a bit times t, and the other way round as far, without a jump.
void ShownTest::whatIsLongMovesSidewaysNoFarther() {
    base::Random random(seed);
    for (int k = 0; k < 2000; ++k) {
        SurfelLayers words;
        words.normal = random.unitVector(), words.support = std::exp(random.uniform(-6, 6));
        words.parts.resize(2);
        const double limit = double(layers::leanLimit) * words.support, far = limit * std::exp(random.uniform(-1, 7));
        words.parts[0].e = random.unitVector() * 0.6;
        words.parts[1].d = random.unitVector() * far;
        const auto at = [&](float strength) { return words.shown(std::vector<float>{strength, 1}).position; };
        const double angle =
            std::acos(std::clamp(dot(words.normal, words.shown(std::vector<float>{1, 1}).normal), -1.0, 1.0));
        const double aside = distance(at(1), at(0));
        QVERIFY2(aside <= 2.2 * limit * angle + 1e-9 * far && aside <= 1.001 * far * angle + 1e-9 * far,
                 qPrintable(QString("%1 of %2 limits at %3, seed %4").arg(aside).arg(limit).arg(angle).arg(seed)));
        words.parts[1].d = normalized(words.parts[1].d) * limit; // where leaning begins to end
        const Vec3d wholly = at(1);
        words.parts[1].d = words.parts[1].d * (1 + 1e-7);
        QVERIFY(distance(at(1), wholly) < 1e-6 * limit);
    }
}

void ShownTest::turnsAreUndoneByTheirReverse() {
    base::Random random(seed);
    for (int k = 0; k < 1000; ++k) {
        const Vec3d a = random.unitVector(), b = random.unitVector(), v = random.unitVector();
        if (dot(a, b) < -0.99)
            continue;
        QVERIFY(distance(layers::turned(a, a, b), b) < 1e-9);
        QVERIFY(distance(layers::turned(layers::turned(v, a, b), b, a), v) < 1e-9);
    }
}

static const test::Registered<ShownTest> registered;
#include "shown_test.moc"
