// What is done is left alone, and what is left to do is not.
#include "core/base/random.h"
#include "core/process/resampling/resample.h"
#include "core/sculpt/tools/settled.h"
#include "sculpt/stroke_samples.h"
#include "support/registry.h"

#include <QTest>

class SettledTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatIsAtItsGoalIsSeenToTwiceAndWhatIsNotAlways();
    void strokesOfDensityReachTheirFactorAllAlong();
};

void SettledTest::whatIsAtItsGoalIsSeenToTwiceAndWhatIsNotAlways() {
    constexpr double s = 0.02;
    const tree::SurfelTree tree = test::surfaceOf(test::planePoints(80, s)).tree();
    base::Random random(test::seed());
    const base::Vec3f centre{float(random.uniform(-0.1, 0.1)), float(random.uniform(-0.1, 0.1)), 0};
    const sculpt::Settled::Ball ball{centre, 0.5f};
    const float cell = ball.radius / 16, diagonal = 1.74f * cell;
    const auto atGoal = [&](const surfel::SurfelBlock& block, int slot) { return block.position(slot).x < centre.x; };
    sculpt::Settled settled(centre, ball.radius);
    for (int dab = 1; dab <= 5; ++dab) {
        const tree::Selection left = settled.drop(tree, process::selectAll(tree), ball, atGoal);
        std::size_t count = 0;
        for (const tree::SelectedBlock& each : left) {
            const surfel::BlockPtr block = tree.block(each.block);
            for (int slot = 0; slot < block->size(); ++slot) {
                if (!each.slots[static_cast<std::size_t>(slot)])
                    continue;
                ++count;
                const base::Vec3f p = block->position(slot);
                const bool done = p.x < centre.x - diagonal && distance(p, centre) < ball.radius - diagonal;
                QVERIFY2(dab <= 2 || !done, qPrintable(QString("dab %1 seed %2").arg(dab).arg(test::seed())));
            }
        }
        std::size_t open = 0; // what may never be left out
        for (const surfel::Surfel& each : tree.surfels().items)
            open += each.position.x >= centre.x || distance(each.position, centre) > ball.radius + diagonal ? 1 : 0;
        QVERIFY2(dab <= 2 ? count == tree.size() : count >= open && count < tree.size(),
                 qPrintable(QString("dab %1: %2 seed %3").arg(dab).arg(count).arg(test::seed())));
    }
}

void SettledTest::strokesOfDensityReachTheirFactorAllAlong() {
    constexpr std::size_t count = 6000;
    base::Random random(test::seed());
    sculpt::StrokeSettings settings = test::settingsOf("density", 0.35f);
    settings.strength = 1;
    const float aside = float(random.uniform(-0.1, 0.1));
    const surface::Surface after = test::stroked(test::surfaceOf(test::spherePoints(count)), settings,
                                                 {test::down(-0.4f, aside), test::down(0.4f, -aside)});
    const double target = 0.6 * test::sphereSpacing(count);
    double sum = 0, places = 0;
    std::vector<tree::Neighbour> near;
    for (const surfel::Surfel& each : after.tree().surfels().items) {
        if (each.position.z < 0 || std::abs(each.position.x) > 0.3f || std::abs(each.position.y) > 0.05f)
            continue;
        after.tree().nearest(each.position, 19, near);
        const double spacing =
            std::sqrt(3.14159265 * double(near.back().distanceSq) / 18.5); // by the area of 18 others
        QVERIFY2(spacing > 0.75 * target && spacing < 1.35 * target,
                 qPrintable(QString("%1 of %2 seed %3").arg(spacing).arg(target).arg(test::seed())));
        sum += spacing, ++places;
    }
    QVERIFY(places > 50);
    QVERIFY2(std::abs(sum / places / target - 1) < 0.12,
             qPrintable(QString("%1 of %2 seed %3").arg(sum / places).arg(target).arg(test::seed())));
}

static const test::Registered<SettledTest> registered;
#include "settled_test.moc"
