// Cuts in lanes, against cuts by sorting.
#include "core/tree/cut_lanes.h"

#include "core/base/box.h"
#include "core/base/random.h"
#include "core/tree/cutting.h"
#include "support/registry.h"

#include <algorithm>
#include <QTest>

using tree::CutItem;
using tree::CutLanes;

class CutLanesTest : public QObject {
    Q_OBJECT
  private Q_SLOTS:
    void cutsAreThoseOfSorting_data();
    void cutsAreThoseOfSorting();
};

namespace {

base::Box3f boxOf(std::span<const CutItem> items) {
    base::Box3f box;
    for (const CutItem& item : items)
        box.extend(base::Vec3f{item.position[0], item.position[1], item.position[2]});
    return box;
}

void sortAlong(std::span<CutItem> items, std::size_t axis) {
    std::sort(items.begin(), items.end(), [axis](const CutItem& a, const CutItem& b) {
        const float p = a.position[axis], q = b.position[axis];
        return p != q ? p < q : a.source < b.source;
    });
}

std::size_t longest(std::span<const CutItem> items) {
    const base::Vec3f s = boxOf(items).size();
    return s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
}

float cost(std::span<const CutItem> items) {
    const base::Vec3f s = boxOf(items).size();
    return s.x + s.y + s.z;
}

void cutClusters(std::span<CutItem> items) {
    if (items.size() <= 16)
        return std::sort(items.begin(), items.end(),
                         [](const CutItem& a, const CutItem& b) { return a.source < b.source; });
    const std::size_t front = (items.size() + 15) / 16 / 2 * 16;
    sortAlong(items, longest(items));
    cutClusters(items.first(front));
    cutClusters(items.subspan(front));
}

void cutBlocks(std::span<CutItem> items, std::size_t blocks, std::vector<std::uint32_t>& sizes) {
    if (blocks == 1) {
        sizes.push_back(static_cast<std::uint32_t>(items.size()));
        return cutClusters(items);
    }
    const std::size_t left = blocks / 2, front = ((items.size() + 15) / 16 * left + blocks / 2) / blocks * 16;
    std::size_t best = longest(items);
    if (blocks <= 16) {
        float least = std::numeric_limits<float>::infinity();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            sortAlong(items, axis);
            const float sum = cost(items.first(front)) + cost(items.subspan(front));
            if (sum < least)
                least = sum, best = axis;
        }
    }
    sortAlong(items, best);
    cutBlocks(items.first(front), left, sizes);
    cutBlocks(items.subspan(front), blocks - left, sizes);
}

} // namespace

void CutLanesTest::cutsAreThoseOfSorting_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("step"); // that coordinates are multiples of, for ties; 0: any
    for (const int count : {1, 15, 16, 17, 33, 100, 128, 129, 500, 1792, 2000, test::effort(20000)})
        for (const double step : {0.0, 0.05, 0.4, 10.0})
            QTest::addRow("%d places, step %g", count, step) << count << step;
}

void CutLanesTest::cutsAreThoseOfSorting() {
    QFETCH(int, count);
    QFETCH(double, step);
    base::Random random(test::seed());
    std::vector<CutItem> items(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < items.size(); ++i) {
        const base::Vec3d p = random.unitVector();
        for (std::size_t k = 0; k < 3; ++k)
            items[i].position[k] = static_cast<float>(step > 0 ? std::round(p[k] / step) * step : p[k]); // -0 as well
        items[i].source = static_cast<std::uint32_t>(i * 2654435761u); // unique, in no order
    }
    CutLanes lanes(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            lanes.axis(k)[i] = items[i].position[k];
        lanes.sources()[i] = items[i].source;
    }
    const std::size_t blocks = tree::blocksFor(items.size());
    std::vector<std::uint32_t> sizes;
    cutBlocks(items, blocks, sizes);
    QCOMPARE(lanes.cut(blocks), sizes);
    for (std::size_t i = 0; i < items.size(); ++i)
        QVERIFY2(lanes.sources()[i] == items[i].source,
                 qPrintable(QString("place %1, seed %2").arg(i).arg(test::seed())));
}

static const test::Registered<CutLanesTest> registered;
#include "cut_lanes_test.moc"
