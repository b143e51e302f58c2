#include "core/process/neighbours/curve_order.h"

#include "core/base/parallel.h"
#include "core/base/radix_sort.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace process {

using surfel::Surfel;

namespace {

constexpr std::size_t grain = 1 << 16;
/// Bits of a code that all points are sorted by at once, beside their number in one word; the rest decides among few.
constexpr int restBits = 3 * base::mortonBits - 32;
/// Runs of points whose codes begin alike: longer ones are sorted by whole codes first.
constexpr std::size_t longRun = 256;

struct CodedPoint {
    std::uint64_t code;
    std::uint32_t point;
};

base::Box3f boxOf(std::span<const Surfel> points) {
    std::vector<base::Box3f> boxes(base::chunkCount(points.size(), grain));
    base::parallelChunks(points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        base::Box3f box; // not shared with other threads' lines
        for (std::size_t i = begin; i < end; ++i)
            box.extend(points[i].position);
        boxes[chunk] = box;
    });
    base::Box3f out;
    for (const base::Box3f& box : boxes)
        out.extend(box);
    return out;
}

/// A total order.
bool before(std::span<const Surfel> points, const CodedPoint& a, const CodedPoint& b) {
    if (a.code != b.code)
        return a.code < b.code;
    const base::Vec3f &p = points[a.point].position, &q = points[b.point].position;
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z != q.z ? p.z < q.z : a.point < b.point;
}

bool areInOrder(std::span<const Surfel> points, const CurveGrid& grid) {
    std::atomic<bool> out = true;
    base::parallelChunks(points.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        const auto coded = [&](std::size_t i) {
            return CodedPoint{grid.code(points[i].position), static_cast<std::uint32_t>(i)};
        };
        CodedPoint last = coded(begin > 0 ? begin - 1 : 0);
        for (std::size_t i = std::max<std::size_t>(begin, 1); i < end && out.load(std::memory_order_relaxed); ++i) {
            const CodedPoint next = coded(i);
            if (!before(points, last, next))
                out.store(false, std::memory_order_relaxed);
            last = next;
        }
    });
    return out;
}

/// Finishes the order of runs that the upper half of their codes does not tell apart.
class Runs {
  public:
    Runs(std::span<const Surfel> points, const CurveGrid& grid) : m_points(points), m_grid(grid) {}

    /// REQUIRES: whole runs.
    void sortAll(std::span<std::uint64_t> keys) {
        for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
            while (end < keys.size() && keys[end] >> 32 == keys[begin] >> 32)
                ++end;
            if (end - begin > 1)
                sort(keys.subspan(begin, end - begin));
        }
    }

  private:
    void sort(std::span<std::uint64_t> keys) {
        std::vector<CodedPoint>& coded = m_coded;
        coded.resize(keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const auto point = static_cast<std::uint32_t>(keys[i]);
            coded[i] = {m_grid.code(m_points[point].position), point};
        }
        if (coded.size() > longRun)
            base::radixSort(coded, restBits, [](const CodedPoint& c) { return c.code; });
        else
            std::sort(coded.begin(), coded.end(),
                      [this](const auto& a, const auto& b) { return before(m_points, a, b); });
        for (std::size_t begin = 0, end = 0; coded.size() > longRun && begin < coded.size(); begin = end) {
            while (end < coded.size() && coded[end].code == coded[begin].code)
                ++end;
            if (end - begin > 1)
                std::sort(coded.begin() + static_cast<std::ptrdiff_t>(begin),
                          coded.begin() + static_cast<std::ptrdiff_t>(end),
                          [this](const auto& a, const auto& b) { return before(m_points, a, b); });
        }
        for (std::size_t i = 0; i < keys.size(); ++i)
            keys[i] = (keys[i] >> 32 << 32) | coded[i].point;
    }

    std::span<const Surfel> m_points;
    const CurveGrid& m_grid;
    std::vector<CodedPoint> m_coded; ///< of one run
};

/// Cuts sorted keys into parts of whole runs, of about a grain each.
std::vector<std::size_t> runStarts(std::span<const std::uint64_t> keys) {
    std::vector<std::size_t> starts(base::chunkCount(keys.size(), grain) + 1, keys.size());
    base::parallelChunks(keys.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        std::size_t i = begin;
        while (i > 0 && i < end && keys[i] >> 32 == keys[i - 1] >> 32)
            ++i;
        starts[chunk] = i < end ? i : keys.size();
    });
    for (std::size_t part = starts.size() - 1; part-- > 0;)
        starts[part] = std::min(starts[part], starts[part + 1]); // within a run that began earlier
    return starts;
}

/// Moves `wide` items for each number in `order` to its place.
template <class Item>
void move(Item* items, std::span<const std::uint32_t> order, std::size_t wide) {
    constexpr std::size_t ahead = 16; // what is read at random is asked for early
    const std::size_t n = order.size();
    base::LargeArray<Item> moved(n * wide);
    base::parallelFor(n, grain, [&](std::size_t i) {
        if (i + ahead < n)
            __builtin_prefetch(items + order[i + ahead] * wide);
        std::copy_n(items + order[i] * wide, wide, moved.data() + i * wide);
    });
    base::parallelFor(n, grain, [&](std::size_t i) { std::copy_n(moved.data() + i * wide, wide, items + i * wide); });
}

} // namespace

CurveOrder::CurveOrder(std::span<const Surfel> points) : grid(boxOf(points)) {
    if (areInOrder(points, grid))
        return;
    const std::size_t n = points.size();
    order = base::LargeArray<std::uint32_t>(n);
    base::LargeArray<std::uint64_t> keys(n);
    base::parallelFor(n, grain, [&](std::size_t i) {
        keys[i] = grid.code(points[i].position) >> restBits << 32 | static_cast<std::uint32_t>(i);
    });
    base::radixSort(keys, 32, [](std::uint64_t key) { return key >> 32; });
    const std::vector<std::size_t> starts = runStarts(keys);
    base::parallelFor(starts.size() - 1, 1, [&](std::size_t part) {
        Runs(points, grid).sortAll(std::span(keys.data() + starts[part], starts[part + 1] - starts[part]));
    });
    base::parallelFor(n, grain, [&](std::size_t i) { order[i] = static_cast<std::uint32_t>(keys[i]); });
}

base::LargeArray<std::uint32_t> putInCurveOrder(surfel::SurfelList& points) {
    base::LargeArray<std::uint32_t> order = std::move(CurveOrder(points.items).order);
    if (order.empty())
        return order;
    move(points.items.data(), order, 1);
    if (const std::size_t words = points.layout->words(); words > 0)
        move(points.extra.data(), order, words);
    return order;
}

} // namespace process
