#include "core/process/resampling/point_grid.h"

#include "core/base/random.h"
#include "support/registry.h"

#include <algorithm>
#include <QTest>

using process::PointGrid;

class PointGridTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void init() { qInfo("seed %llu", static_cast<unsigned long long>(test::seed())); }
    void findsAllThatLieNear_data();
    void findsAllThatLieNear();
    void walksMeetAllNeighbours_data() { findsAllThatLieNear_data(); }
    void walksMeetAllNeighbours();
    void passesOverWhatIsFarInACrowdedCell();
    void boxesOfAnySizeHaveCells();
};

/// Pairs of points within a cell of each other, `spread` cells apart: where cells have keys of their own, where the
/// keys wrap, and so far away that whole numbers end and all lie in the last cell there is.
static std::vector<PointGrid::Entry> pairs(float cell, float spread) {
    base::Random random(test::seed());
    std::vector<PointGrid::Entry> out;
    for (int i = 0; i < 200; ++i) {
        const auto at = base::cast<float>(random.unitVector()) * (spread * cell * static_cast<float>(random.uniform()));
        const auto beside = at + base::cast<float>(random.unitVector()) * (0.6f * cell);
        for (const base::Vec3f& p : {at, beside})
            out.push_back({p, static_cast<std::uint32_t>(out.size())});
    }
    return out;
}

template <class Walk>
static bool meetsAll(const std::vector<PointGrid::Entry>& entries, float radius, const Walk& walk) {
    for (const PointGrid::Entry& each : entries) {
        const std::vector<std::uint32_t> met = walk(each);
        for (const PointGrid::Entry& other : entries)
            if (distance(each.position, other.position) < radius &&
                std::count(met.begin(), met.end(), other.index) != 1)
                return false;
    }
    return true;
}

void PointGridTest::findsAllThatLieNear_data() {
    QTest::addColumn<float>("spread");
    for (const float spread : {3.0f, 30.0f, 3e4f, 4e6f, 1e12f, 1e25f})
        QTest::addRow("spread=%g", double(spread)) << spread;
}

void PointGridTest::findsAllThatLieNear() {
    QFETCH(float, spread);
    constexpr float cell = 0.125f;
    const auto entries = pairs(cell, spread);
    PointGrid built({}, cell), filled({}, cell);
    built.build(entries);
    filled.build({});
    for (const PointGrid::Entry& each : entries)
        filled.insert(each);
    for (const PointGrid* grid : {&built, &filled})
        QVERIFY(meetsAll(entries, cell, [&](const PointGrid::Entry& each) {
            std::vector<std::uint32_t> met;
            grid->forNear(each.position, cell, [&](const PointGrid::Entry& e) { met.push_back(e.index); });
            return met;
        }));
}

void PointGridTest::walksMeetAllNeighbours() {
    QFETCH(float, spread);
    constexpr float cell = 0.125f;
    const auto entries = pairs(cell, spread);
    PointGrid grid({}, cell);
    grid.build(entries);
    std::vector<std::vector<std::uint32_t>> met(entries.size());
    PointGrid::Walk walk(grid, 0);
    for (std::size_t rank = 0; rank < grid.cellCount(); ++rank)
        walk.around(rank, [&](std::size_t near) {
            for (const PointGrid::Entry& member : grid.members(rank))
                for (const PointGrid::Entry& e : grid.members(near))
                    met[member.index].push_back(e.index);
        });
    QVERIFY(meetsAll(entries, cell, [&](const PointGrid::Entry& each) { return met[each.index]; }));
}

void PointGridTest::passesOverWhatIsFarInACrowdedCell() {
    // As in a tree: points that follow each other lie side by side. All are in a cell or two of the coarsest sampling.
    base::Random random(test::seed());
    std::vector<PointGrid::Entry> entries;
    base::Vec3f at{0.5f, 0.5f, 0.5f};
    constexpr float step = 0.02f;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        at += base::cast<float>(random.unitVector()) * step;
        for (std::size_t k = 0; k < 3; ++k)
            at[k] = std::clamp(at[k], 0.0f, 1.0f);
        entries.push_back({at, i});
    }
    PointGrid built({}, 4), filled({}, 4);
    built.build(entries);
    for (const PointGrid::Entry& each : entries)
        filled.insert(each);
    for (const PointGrid* grid : {&built, &filled}) {
        std::size_t met = 0;
        for (const PointGrid::Entry& each : entries)
            grid->forNear(each.position, step, [&](const PointGrid::Entry&) { ++met; });
        QVERIFY2(met < entries.size() * entries.size() / 8, qPrintable(QString::number(met)));
        QVERIFY(meetsAll(entries, step, [&](const PointGrid::Entry& each) {
            std::vector<std::uint32_t> found;
            grid->forNear(each.position, step, [&](const PointGrid::Entry& e) { found.push_back(e.index); });
            return found;
        }));
    }
}

void PointGridTest::boxesOfAnySizeHaveCells() {
    const PointGrid grid({}, 0.5f);
    QCOMPARE(grid.cellsIn({{0.1f, 0.1f, 0.1f}, {0.9f, 0.4f, 1.4f}}), 6.0);
    const double large = grid.cellsIn({{-1e15f, -1e15f, -1e15f}, {1e15f, 1e15f, 1e15f}});
    QVERIFY(large > 6e46 && large < 7e46);
}

static const test::Registered<PointGridTest> registered;
#include "point_grid_test.moc"
