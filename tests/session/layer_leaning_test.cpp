// What was drawn out on one layer stays sound whatever becomes of the surface below it.
#include "core/base/random.h"
#include "core/tree/nearest_together.h"
#include "layered.h"
#include "support/registry.h"

#include <QTest>

using base::Vec3d, base::Vec3f;
using test::Workbench, test::json;
using namespace test::layered;

class LayerLeaningTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void hornsStaySoundAsTheReliefBelowThemGoes_data();
    void hornsStaySoundAsTheReliefBelowThemGoes();
};

namespace {

constexpr double radius = 0.25, top = 0.93;

/// Strokes across the pole, whose slopes differ from surfel to surfel.
void sculptRelief(Workbench& bench, base::Random& random, const char* tool) {
    for (int k = 0; k < 4; ++k) {
        const double turn = random.uniform(0, 6.28), aside = random.uniform(-0.1, 0.1);
        json samples = json::array();
        for (int i = 0; i <= 24; ++i) {
            const double along = 0.35 * (i / 12.0 - 1);
            samples.push_back({along * std::cos(turn) + aside, along * std::sin(turn), 3, 0, 0, -1, 1, 0.05 * i});
        }
        bench.run({{"op", "stroke"}, {"tool", tool}, {"radius", 0.2}, {"strength", 0.5}, {"samples", samples}});
    }
}

/// Pulled up by the diameter of its brush and more.
void pullHorn(Workbench& bench, const char* tool) {
    json samples = json::array();
    for (int i = 0; i < 40; ++i)
        samples.push_back({0, -5, top + 0.8 * i / 39.0, 0, 1, 0, 1, 0.05 * i});
    bench.run({{"op", "stroke"}, {"tool", tool}, {"radius", radius}, {"samples", samples}});
}

/// How many surfels have no surface around them: neighbours look elsewhere, or are far off.
int torn(const Workbench& bench) {
    const tree::SurfelTree& tree = bench.document.surface().tree();
    std::vector<tree::Neighbour> near;
    int out = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            tree.nearest(block.position(slot), 7, near);
            float alike = -1, far = 0;
            for (const tree::Neighbour& each : near)
                alike += dot(block.normal(slot), each.block->normal(each.slot)), far += std::sqrt(each.distanceSq);
            const float spacing = block.support(slot) / 3.5f;
            out += alike < 0.5f * 6 || far > 2 * 6 * spacing ? 1 : 0;
        }
    });
    return out;
}

} // namespace

void LayerLeaningTest::hornsStaySoundAsTheReliefBelowThemGoes_data() {
    QTest::addColumn<QString>("relief");
    QTest::addColumn<QString>("puller");
    QTest::newRow("draw, snake-hook") << "draw"
                                      << "snake-hook";
    QTest::newRow("clay, grab") << "clay"
                                << "grab";
}

void LayerLeaningTest::hornsStaySoundAsTheReliefBelowThemGoes() {
    QFETCH(QString, relief);
    QFETCH(QString, puller);
    base::Random random(test::seed());
    Workbench bench;
    bench.run(test::newSphere(6000));
    bench.run(layer("add", {{"name", "relief"}}));
    sculptRelief(bench, random, qPrintable(relief));
    bench.run(layer("add", {{"name", "horn"}}));
    pullHorn(bench, qPrintable(puller));
    QVERIFY(offSphere(surfels(bench)) > 0.6);
    const int before = torn(bench);
    for (const double strength : {0.6, 0.3, 0.0}) {
        bench.run(layer("strength", {{"name", "relief"}, {"strength", strength}}));
        QVERIFY(isWhole(bench));
        const int after = torn(bench);
        QVERIFY2(
            after <= before,
            qPrintable(
                QString("%1 -> %2 at strength %3, seed %4").arg(before).arg(after).arg(strength).arg(test::seed())));
    }
}

static const test::Registered<LayerLeaningTest> registered;
#include "layer_leaning_test.moc"
