#include "core/sculpt/stretches.h"

#include "core/base/random.h"
#include "sculpt/shapes.h"
#include "support/registry.h"

#include <QTest>
#include <unordered_map>

using namespace sculpt;
using base::Vec3f;

class StretchesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void whatMovesAsOnePieceIsNotStretched();
    void stretchIsMeasuredSinceItWasTaken();
    void onlyWhatMovedAndIsBeyondTheLimitsIsTaken();
    void smoothingNoiseBringsNothingTogether();
    void theMostStrainedGoFirstAndNothingWaitsTooLong();
};

constexpr double s = 0.02;

/// The surfels that are asked for beyond the limits.
static tree::Selection beyond(Stretches& stretches, const tree::SurfelTree& now, const StretchRange& limits) {
    stretches.ask(limits);
    return stretches.take(now, [](const Stretches::Tracked&, int) { return true; });
}

static tree::SurfelTree plane() {
    return tree::SurfelTree::build(test::planePoints(60, s));
}

/// Every block with its surfels where `to` puts them; unchanged blocks are left out.
template <class To>
static tree::Edit moved(const tree::SurfelTree& tree, const To& to) {
    tree::Edit edit;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        const surfel::MutableBlockPtr out = block.clone();
        bool any = false;
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3f p = to(block.position(slot));
            any |= p != block.position(slot);
            out->setPosition(slot, p);
        }
        out->seal();
        if (any)
            edit.blocks.push_back({number, out, {}});
    });
    return edit;
}

void StretchesTest::whatMovesAsOnePieceIsNotStretched() {
    const tree::SurfelTree start = plane();
    Stretches stretches;
    const float way = stretches.note(start, moved(start, [](Vec3f p) { return Vec3f{-p.y, p.x, 2}; }));
    QVERIFY(way > 2 && way < 5);
    QVERIFY2(std::abs(stretches.range().most - 1) < 1e-4f && std::abs(stretches.range().least - 1) < 1e-4f,
             qPrintable(QString::number(double(stretches.range().most))));
}

void StretchesTest::stretchIsMeasuredSinceItWasTaken() {
    tree::SurfelTree now = plane();
    Stretches stretches;
    for (int k = 1; k <= 3; ++k) { // 1.2, 1.44, 1.73 along x
        const tree::Edit edit = moved(now, [](Vec3f p) { return Vec3f{1.2f * p.x, p.y, p.z}; });
        stretches.note(now, edit);
        now = now.apply(edit);
        const float full = std::pow(1.2f, float(k));
        QVERIFY2(stretches.range().most < full * 1.001f && stretches.range().most > 1 + 0.85f * (full - 1),
                 qPrintable(QString::number(double(stretches.range().most))));
        QVERIFY(std::abs(stretches.range().least - 1) < 1e-3f);
    }
    QVERIFY(tree::sizeOf(beyond(stretches, now, {0.5f, 1.5f})) > now.size() - 100); // x = 0 stays
    QVERIFY(stretches.range().most < 1.5f && beyond(stretches, now, {0.5f, 1.5f}).empty());
    stretches.note(now, moved(now, [](Vec3f p) { return p * 0.5f; }));
    QVERIFY(stretches.range().least < 0.6f && stretches.range().most < 1.01f);
}

void StretchesTest::onlyWhatMovedAndIsBeyondTheLimitsIsTaken() {
    const tree::SurfelTree start = plane();
    Stretches stretches;
    // The right side is carried along as a piece and the middle is torn out.
    const tree::Edit edit = moved(start, [](Vec3f p) {
        return Vec3f{p.x < 0 ? p.x : p.x < 0.2f ? 3 * p.x : p.x + 0.4f, p.y, p.z};
    });
    stretches.note(start, edit);
    const tree::SurfelTree now = start.apply(edit);
    const tree::Selection taken = beyond(stretches, now, {0.5f, 1.5f});
    QVERIFY(!taken.empty() && tree::sizeOf(taken) < now.size() / 2);
    for (const auto& [number, chosen] : taken)
        for (int slot = 0; slot < now.block(number)->size(); ++slot)
            QVERIFY(!chosen[std::size_t(slot)] || now.block(number)->position(slot).x > 0);
    QVERIFY(stretches.range().most < 1.5f);
}

void StretchesTest::smoothingNoiseBringsNothingTogether() {
    base::Random random(test::seed());
    surfel::SurfelList points = test::planePoints(60, s);
    for (surfel::Surfel& each : points.items)
        each.position.z = float(random.uniform(-0.4, 0.4) * s);
    const tree::SurfelTree rough = tree::SurfelTree::build(points);
    Stretches stretches;
    stretches.note(rough, moved(rough, [](Vec3f p) { return Vec3f{p.x, p.y, 0}; }));
    const StretchRange range = stretches.range();
    QVERIFY2(range.least > 0.9f && range.most < 1.1f,
             qPrintable(QString("%1 to %2, seed %3").arg(range.least).arg(range.most).arg(test::seed())));
}

/// x drawn apart by 1 + |x|: more and more outwards.
void StretchesTest::theMostStrainedGoFirstAndNothingWaitsTooLong() {
    constexpr StretchRange limits{0.75f, 1.2f}, must{0.4f, 1.5f};
    const tree::SurfelTree start = plane();
    const tree::Edit edit = moved(start, [](Vec3f p) { return Vec3f{p.x * (1 + 0.5f * std::abs(p.x)), p.y, 0}; });
    const tree::SurfelTree now = start.apply(edit);
    for (const std::size_t count : {std::size_t(1), std::size_t(1000), std::size_t(100000)}) {
        Stretches stretches;
        stretches.note(start, edit);
        const std::size_t waiting = stretches.beyond(limits), late = stretches.beyond(must);
        QVERIFY(late > 200 && late + 200 < waiting && waiting < now.size());
        // The least strained of those taken, the most of the others.
        std::unordered_map<const surfel::SurfelBlock*, float> strain;
        stretches.forEach([&](const Stretches::Tracked& each) { strain[each.now.get()] = each.range.strain(must); });
        stretches.askMost(now, limits, must, count);
        QVERIFY(stretches.range().within(must));
        const tree::Selection taken = stretches.take(now, [](const Stretches::Tracked&, int) { return true; });
        float least = 1e9f;
        for (const tree::SelectedBlock& each : taken) {
            const surfel::SurfelBlock* block = now.block(each.block).get();
            least = std::min(least, strain.at(block));
            strain.erase(block);
        }
        for (const auto& [block, of] : strain)
            QVERIFY(of <= least || count > now.size());
        const std::size_t left = stretches.beyond(limits), done = waiting - left;
        QVERIFY(done >= std::min(std::max(count, late), waiting) && done < std::max(count, late) + 200);
        QVERIFY(tree::sizeOf(taken) <= done && tree::sizeOf(taken) + 200 > done);
    }
}

static const test::Registered<StretchesTest> registered;
#include "stretches_test.moc"
