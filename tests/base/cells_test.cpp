#include "core/base/cells.h"
#include "core/base/morton.h"
#include "core/base/radix_sort.h"
#include "core/base/random.h"
#include "core/base/unit_normal.h"
#include "support/registry.h"

#include <algorithm>
#include <map>
#include <QTest>
#include <tuple>

using namespace base;

class CellsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void mortonCodesKeepCoordinates();
    void sortsByKeyAndKeepsTheOrderOfEquals();
    void cellsAreOrderedByCoordinates();
    void everyCellHasCellsAround();
    void mapFindsWhatWasPutIn();
    void unitNormalsKeepTheirBits();
};

static Cell randomCell(Random& random) {
    const auto one = [&] { return static_cast<std::int64_t>(random.below(40)) - 20; };
    const std::int64_t x = one(), y = one(), z = one();
    return {x, y, z};
}

void CellsTest::mortonCodesKeepCoordinates() {
    Random random(test::seed());
    QCOMPARE(mortonCode(1, 0, 0), std::uint64_t(1));
    QCOMPARE(mortonCode(0, 3, 1), std::uint64_t(0b10110));
    for (int k = 0; k < 1000; ++k) {
        std::uint32_t v[3];
        for (std::uint32_t& each : v)
            each = static_cast<std::uint32_t>(random.below(1u << mortonBits));
        const std::uint64_t code = mortonCode(v[0], v[1], v[2]);
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(mortonCoordinate(code, axis), v[axis]);
    }
}

void CellsTest::sortsByKeyAndKeepsTheOrderOfEquals() {
    Random random(test::seed() + 1);
    using Item = std::pair<std::uint64_t, std::uint32_t>;
    for (const int bits : {3, 11, 30, 63}) {
        std::vector<Item> items(200000);
        for (std::uint32_t i = 0; i < items.size(); ++i)
            items[i] = {random.next() >> (64 - bits), i};
        std::vector<Item> expected = items;
        std::sort(expected.begin(), expected.end()); // by key, then by what the order was
        radixSort(items, bits, [](const Item& item) { return item.first; });
        QVERIFY(items == expected);
    }
}

void CellsTest::cellsAreOrderedByCoordinates() {
    Random random(test::seed() + 2);
    for (int k = 0; k < 1000; ++k) {
        const Cell a = randomCell(random), b = randomCell(random);
        QCOMPARE(a.key() < b.key(), std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z));
    }
    const Cell c = cellOf(Vec3d{-0.1, 1.0, 2.6}, Vec3d{0, 0, 0}, 2);
    QVERIFY(c.x == -1 && c.y == 2 && c.z == 5);
}

void CellsTest::everyCellHasCellsAround() {
    QCOMPARE(cellNumber(-0.25), std::int64_t(-1));
    QCOMPARE(cellNumber(7.0f), std::int64_t(7));
    for (const double far : {1e17, -1e17, 1e19, -1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        int cells = 0;
        forCellsAround(cellOf(Vec3d{far, 1, -far}, Vec3d(), 1.0),
                       [&](const Cell& cell) { cells += std::abs(cell.y) <= 2 ? 1 : 0; });
        QCOMPARE(cells, 27);
    }
    QCOMPARE(cellOf(Vec3d{1e17, 0, 0}, Vec3d(), 1.0).x, std::int64_t(1e17));
}

void CellsTest::mapFindsWhatWasPutIn() {
    Random random(test::seed() + 3);
    CellMap<int> map;
    std::map<std::uint64_t, int> expected;
    QVERIFY(!map.find({0, 0, 0}));
    for (int k = 0; k < 5000; ++k) {
        const Cell put = randomCell(random), asked = randomCell(random);
        ++map.at(put), ++expected[put.key()];
        const auto known = expected.find(asked.key());
        const int* found = map.find(asked);
        QCOMPARE(found != nullptr, known != expected.end());
        QVERIFY(!found || *found == known->second);
    }
}

void CellsTest::unitNormalsKeepTheirBits() {
    Random random(test::seed() + 4);
    for (int k = 0; k < 1000; ++k) {
        const Vec3f n = cast<float>(random.unitVector());
        QVERIFY(unitNormal(n) == n);
        QVERIFY(std::abs(lengthSq(unitNormal(n * 1.001f)) - 1) <= unitTolerance);
    }
    QVERIFY(unitNormal({}) == Vec3f{});
}

static const test::Registered<CellsTest> registered;
#include "cells_test.moc"
