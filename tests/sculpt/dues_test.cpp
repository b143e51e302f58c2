// What dabs of wide brushes owe is done, once.
#include "core/base/random.h"
#include "core/sculpt/tools/dues.h"
#include "sculpt/shapes.h"
#include "support/registry.h"

#include <QTest>

#include <cmath>

class DuesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void strengthIsNeitherLostNorDoneTwice();
    void whatIsAtItsGoalIsOwedNothingMore();
};

namespace {

/// A plane with random dabs over it: what surfels are owed, by the cells that dabs reach, and what they get.
struct Plane {
    base::Random random{test::seed()};
    tree::SurfelTree tree = test::surfaceOf(test::planePoints(90, 0.02)).tree();
    float radius = float(random.uniform(0.3, 0.5));
    sculpt::Dues dues{{0.1f, 0.1f, 0}, radius};
    std::size_t most = std::size_t(random.uniform(100, 600)), mostInCell = 0, mostAtOnce = 0, looks = 0;
    std::vector<double> got = std::vector<double>(tree.blockCount() * surfel::blockCapacity, 0.0);
    int turnsAtGoal = 2;
    bool there = false;

    sculpt::Dues::Wanted wanted() {
        return {tree, most, turnsAtGoal, false, [this](const sculpt::Dues::Cell& cell) {
                    std::size_t count = 0;
                    for (const tree::SelectedBlock& each : cell.surfels)
                        count += each.slots.count();
                    mostInCell = std::max(mostInCell, count), ++looks;
                    return sculpt::Dues::Seen{cell.surfels, cell.surfels, there, true};
                }};
    }
    void take(const sculpt::Dues::Turn& turn) {
        std::size_t count = 0;
        for (const tree::SelectedBlock& each : turn.which) {
            count += each.slots.count();
            for (std::size_t slot = 0; slot < surfel::blockCapacity; ++slot)
                if (each.slots[slot])
                    got[each.block * surfel::blockCapacity + slot] += double(turn.strength);
        }
        mostAtOnce = std::max(mostAtOnce, count);
    }
    base::Vec3f place() { return {float(random.uniform(-0.5, 0.5)), float(random.uniform(-0.5, 0.5)), 0}; }
    void finish() {
        while (const auto left = dues.firstDab())
            take(dues.rest(*left, wanted()));
    }
};

} // namespace

void DuesTest::strengthIsNeitherLostNorDoneTwice() {
    Plane plane;
    struct Done {
        base::Vec3f at;
        double strength;
    };
    std::vector<Done> done;
    for (int dab = 0; dab < 30; ++dab) {
        const Done each{plane.place(), plane.random.uniform(0.05, 1)};
        plane.dues.owe(plane.tree, each.at, plane.radius, float(each.strength));
        plane.take(plane.dues.next(plane.wanted()));
        done.push_back(each);
    }
    plane.finish();
    QVERIFY2(plane.mostAtOnce < plane.most + plane.mostInCell, qPrintable(QString::number(plane.mostAtOnce)));
    const float diagonal = 1.74f * plane.radius / 4; // of a cell
    for (std::uint32_t number = 0; number < plane.tree.blockCount(); ++number) {
        const surfel::BlockPtr block = plane.tree.block(number);
        for (int slot = 0; slot < block->size(); ++slot) {
            double least = 0, most = 0; // by dabs that surely, or perhaps, reach its cell
            for (const Done& each : done) {
                const float apart = distance(block->position(slot), each.at);
                least += apart < plane.radius ? each.strength : 0;
                most += apart < plane.radius + diagonal ? each.strength : 0;
            }
            const double got = plane.got[number * surfel::blockCapacity + std::size_t(slot)];
            QVERIFY2(got > least - 0.05 && got < most + 1e-4,
                     qPrintable(QString("%1 of %2 to %3, seed %4").arg(got).arg(least).arg(most).arg(test::seed())));
        }
    }
}

void DuesTest::whatIsAtItsGoalIsOwedNothingMore() {
    Plane plane;
    plane.there = true;
    for (int dab = 0; dab < 20; ++dab) {
        plane.dues.owe(plane.tree, {}, plane.radius, 1);
        plane.take(plane.dues.next(plane.wanted()));
    }
    plane.finish();
    for (const double got : plane.got)
        QVERIFY2(got <= plane.turnsAtGoal, qPrintable(QString("%1, seed %2").arg(got).arg(test::seed())));
    plane.there = false; // and again, once it is not
    plane.got.assign(plane.got.size(), 0);
    plane.dues.owe(plane.tree, {}, plane.radius, 1);
    plane.take(plane.dues.next(plane.wanted()));
    QVERIFY(*std::max_element(plane.got.begin(), plane.got.end()) == 1);
}

static const test::Registered<DuesTest> registered;
#include "dues_test.moc"
