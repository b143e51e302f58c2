// What a block by itself tells of the spacing around its surfels is what it holds, and bounds what is measured.
#include "core/base/random.h"
#include "core/sculpt/kept_spacing.h"
#include "core/sculpt/own_block.h"
#include "support/registry.h"

#include <numeric>
#include <QTest>

using sculpt::OwnBlock;

class OwnBlockTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void countsAndRingsAreThoseOfTheBlock();
    void ringsBoundWhatIsMeasuredWhereNothingLiesByChance();
};

namespace {

/// Places at random on two sheets that face apart, some in one place, some without a normal.
tree::SurfelTree randomSheets(base::Random& random) {
    surfel::SurfelList list;
    const double apart = random.uniform(0, 0.2);
    for (int i = 0; i < 1500; ++i) {
        surfel::Surfel s;
        s.position = {static_cast<float>(random.uniform()), static_cast<float>(random.uniform()),
                      static_cast<float>(random.below(2) == 0 ? 0 : apart)};
        s.normal = {0, 0, s.position.z > 0 ? 1.0f : -1.0f};
        if (random.below(20) == 0)
            s.normal = {};
        if (random.below(10) == 0 && !list.items.empty())
            s.position = list.items.back().position;
        s.support = 0.1f;
        list.items.push_back(s);
    }
    return tree::SurfelTree::build(list);
}

/// By the definition, in double.
double ringOf(const surfel::SurfelBlock& block, int slot) {
    std::vector<double> away;
    for (int k = 0; k < block.size(); ++k)
        if (block.position(k) != block.position(slot) && dot(block.normal(k), block.normal(slot)) >= 0)
            away.push_back(static_cast<double>(distance(block.position(k), block.position(slot))));
    if (away.size() < 6)
        return std::numeric_limits<double>::infinity();
    std::sort(away.begin(), away.end());
    return 0.93 * std::accumulate(away.begin(), away.begin() + 6, 0.0) / 6;
}

} // namespace

void OwnBlockTest::countsAndRingsAreThoseOfTheBlock() {
    base::Random random(test::seed());
    for (int round = 0; round < 4; ++round) {
        const tree::SurfelTree tree = randomSheets(random);
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            float radiusSq[surfel::blockCapacity] = {};
            for (float& each : radiusSq)
                each = static_cast<float>(random.uniform(0, 0.02));
            OwnBlock seen;
            lookWithin(block, radiusSq, seen);
            for (int slot = 0; slot < block.size(); ++slot) {
                int within = 0;
                for (int k = 0; k < block.size(); ++k)
                    within += distanceSq(block.position(k), block.position(slot)) <= radiusSq[slot] ? 1 : 0;
                const double ring = ringOf(block, slot), found = static_cast<double>(seen.ring[slot]);
                QVERIFY2(within == static_cast<int>(seen.within[slot]), qPrintable(QString::number(test::seed())));
                QVERIFY2(ring == found || std::abs(ring - found) < 1e-5 * ring,
                         qPrintable(QString("%1 for %2, seed %3").arg(found).arg(ring).arg(test::seed())));
            }
        });
    }
}

void OwnBlockTest::ringsBoundWhatIsMeasuredWhereNothingLiesByChance() {
    base::Random random(test::seed());
    const surface::Surface surface(randomSheets(random), {});
    const sculpt::KeptSpacing kept(surface, 0.03f);
    int even = 0;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        OwnBlock seen;
        lookWithin(block, {}, seen);
        for (int slot = 0; slot < block.size(); ++slot)
            if (const sculpt::LocalSpacing at = kept.measured(block, slot); at.even && at.steady) {
                ++even;
                QVERIFY2(at.value <= seen.ring[slot], qPrintable(QString::number(test::seed())));
            }
    });
    QVERIFY(even > 0);
}

static const test::Registered<OwnBlockTest> registered;
#include "own_block_test.moc"
