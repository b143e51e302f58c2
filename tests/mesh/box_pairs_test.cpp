// Pairs of boxes: those that all comparisons find, whatever their sizes and however many share a place.
#include "core/base/random.h"
#include "core/mesh/check/box_pairs.h"

#include "support/registry.h"
#include "support/threads.h"
#include <QTest>

using base::Box3d, base::Vec3d, mesh::BoxPair;

class BoxPairsTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void pairsAreThoseOfAllComparisons();
    void manyInOnePlaceEnd();
    void threadsDoNotShow();
};

namespace {

/// Of all sizes, some flat, some at the same places: coordinates are of few values where `steps` is small.
std::vector<Box3d> randomBoxes(base::Random& random, std::size_t count, double steps) {
    const auto coordinate = [&](double reach) { return std::round(random.uniform(-reach, reach) * steps) / steps; };
    std::vector<Box3d> out;
    for (std::size_t i = 0; i < count; ++i) {
        const double size = std::pow(10, random.uniform(-3, i % 50 == 0 ? 1 : -1));
        const Vec3d at{coordinate(2), coordinate(1), coordinate(0.2)};
        Box3d box{at, at};
        box.extend(at + Vec3d{coordinate(size), coordinate(size), coordinate(size)});
        out.push_back(i % 7 == 1 ? out.back() : box);
    }
    return out;
}

std::vector<BoxPair> all(std::span<const Box3d> boxes) {
    return mesh::overlappingBoxes(boxes, [](const BoxPair&) { return true; });
}

} // namespace

void BoxPairsTest::pairsAreThoseOfAllComparisons() {
    QVERIFY(all({}).empty());
    base::Random random(test::seed());
    for (int round = 0; round < test::effort(6); ++round) {
        const std::vector<Box3d> boxes =
            randomBoxes(random, 200 + random.below(1500), std::pow(10, random.uniform(0.5, 5)));
        std::vector<BoxPair> expected;
        for (std::uint32_t a = 0; a < boxes.size(); ++a)
            for (std::uint32_t b = a + 1; b < boxes.size(); ++b)
                if (!boxes[a].cut(boxes[b]).empty())
                    expected.emplace_back(a, b);
        const QString where = QString("seed %1, round %2").arg(test::seed()).arg(round);
        QVERIFY2(all(boxes) == expected, where.toUtf8());
        std::erase_if(expected, [](const BoxPair& pair) { return pair.first % 3 != 0; });
        const auto some = mesh::overlappingBoxes(boxes, [](const BoxPair& pair) { return pair.first % 3 == 0; });
        QVERIFY2(some == expected, where.toUtf8());
    }
}

/// Half of the boxes at the lowest or highest place, and all in one.
void BoxPairsTest::manyInOnePlaceEnd() {
    for (const double end : {0., 1.}) {
        std::vector<Box3d> boxes;
        for (std::size_t i = 0; i < 1200; ++i) {
            const double y = static_cast<double>(i) / 1200;
            const double x = i % 3 == 0 ? (1 + y) / 3 : end;
            boxes.push_back({{x, y, 0}, {x, y + 1e-6, 0}});
        }
        QVERIFY(all(boxes).empty());
        const std::vector<Box3d> same(600, boxes[0]);
        QCOMPARE(all(same).size(), std::size_t(600 * 599 / 2));
    }
}

void BoxPairsTest::threadsDoNotShow() {
    base::Random random(5);
    const std::vector<Box3d> boxes = randomBoxes(random, 2000, 1e4);
    const auto work = [&] { return all(boxes); };
    const auto one = test::onThreads(1, work), two = test::onThreads(2, work);
    QVERIFY(one == two && !one.empty());
}

static const test::Registered<BoxPairsTest> registered;
#include "box_pairs_test.moc"
