#include "core/process/estimation/piles.h"

#include "core/process/estimation/duplicates.h"

#include <algorithm>
#include <numeric>

namespace process {

namespace {

using base::Box3f;
using base::Vec3f;

/// A pile's box is at most this part of the box that holds it and something else: far less than it must be in the end.
constexpr float suspicious = 1.0f / 64;
/// Boxes are cut here rather than in their middle, where symmetric models have piles.
constexpr float cutAt = 0.4375f;
/// Below, squares lose their digits, and nothing is left out for its distances.
constexpr float tiny = 1e-15f;

/// Positions that lie together in the order, whole cells at first.
struct Bunch {
    std::uint32_t begin, end;
    Box3f box;
    float closestSq; ///< no larger than any squared distance to a (leastPile - 1)th neighbour
    bool whole;      ///< a cell in its own order, of which nothing is written down
};

struct Range {
    std::vector<Bunch> bunches;
    float outer; ///< extent of what it is a half of

    std::size_t size() const {
        std::size_t out = 0;
        for (const Bunch& bunch : bunches)
            out += bunch.end - bunch.begin;
        return out;
    }
    Box3f box() const {
        Box3f out;
        for (const Bunch& bunch : bunches)
            out.extend(bunch.box);
        return out;
    }
    float closestSq() const {
        float out = std::numeric_limits<float>::infinity();
        for (const Bunch& bunch : bunches)
            out = std::min(out, bunch.closestSq);
        return out;
    }
};

class Search {
  public:
    /// Room for so many.
    Search(std::span<const Vec3f> positions, std::size_t count, std::vector<Pile>& out)
        : m_positions(positions), m_order(count), m_out(out) {}

    std::span<std::uint32_t> order() { return m_order; }
    Bunch bunch(std::uint32_t begin, std::uint32_t end, float closestSq) const {
        Bunch out{begin, end, {}, closestSq, false};
        for (std::uint32_t i = begin; i < end; ++i)
            out.box.extend(m_positions[m_order[i]]);
        return out;
    }

    void run(Range whole, const base::Progress& progress) {
        m_open.push_back(std::move(whole));
        for (std::size_t step = 0; !m_open.empty(); ++step) {
            if (step % 256 == 0)
                progress.step(0, "Looking for duplicates");
            const Range each = std::move(m_open.back());
            m_open.pop_back();
            cut(each);
        }
    }

  private:
    void cut(const Range& range) {
        if (range.size() < leastPile)
            return;
        const Box3f box = range.box();
        const Vec3f size = box.size();
        const float extent = length(size), largest = suspicious * extent;
        if (extent <= suspicious * range.outer)
            return keep(range, extent);
        // Members of a pile have leastPile - 1 others within its extent.
        if (extent > tiny && range.closestSq() > 1.01f * largest * largest)
            return;
        const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const float at = box.lo[axis] + cutAt * size[axis];
        Range lower{{}, extent}, upper{{}, extent};
        for (const Bunch& each : range.bunches)
            divide(each, axis, at, lower, upper);
        if (lower.bunches.empty() || upper.bunches.empty())
            return; // as close as floats can be
        m_open.push_back(std::move(lower));
        m_open.push_back(std::move(upper));
    }

    void keep(const Range& range, float extent) {
        Pile& pile = m_out.emplace_back();
        pile.extent = extent;
        for (const Bunch& each : range.bunches) {
            writeDown(each);
            pile.members.insert(pile.members.end(), m_order.begin() + each.begin, m_order.begin() + each.end);
        }
    }

    void writeDown(const Bunch& each) {
        if (each.whole)
            std::iota(m_order.begin() + each.begin, m_order.begin() + each.end, each.begin);
    }

    void divide(const Bunch& each, std::size_t axis, float at, Range& lower, Range& upper) {
        if (each.box.hi[axis] <= at)
            return lower.bunches.push_back(each);
        if (each.box.lo[axis] > at)
            return upper.bunches.push_back(each);
        writeDown(each);
        const auto middle = std::partition(m_order.begin() + each.begin, m_order.begin() + each.end,
                                           [&](std::uint32_t i) { return m_positions[i][axis] <= at; });
        const auto half = static_cast<std::uint32_t>(middle - m_order.begin());
        lower.bunches.push_back(bunch(each.begin, half, each.closestSq));
        upper.bunches.push_back(bunch(half, each.end, each.closestSq));
    }

    std::span<const Vec3f> m_positions;
    base::LargeArray<std::uint32_t> m_order;
    std::vector<Pile>& m_out;
    std::vector<Range> m_open;
};

} // namespace

std::vector<Pile> findPiles(const Cloud& cloud, std::span<const float> closestPile, const base::Progress& progress) {
    std::vector<Pile> out;
    const PointCells& cells = cloud.cells();
    Range whole{{}, 0};
    whole.bunches.reserve(cells.count());
    for (const PointCells::Node& node : cells.nodes)
        if (node.cell != PointCells::inner)
            whole.bunches.push_back(
                {cells.begin[node.cell], cells.begin[node.cell + 1], node.box, closestPile[node.cell], true});
    Search(cloud.positions(), cloud.size(), out).run(std::move(whole), progress);
    return out;
}

void findPiles(std::span<const Vec3f> positions, const Pile& within, const base::Progress& progress,
               std::vector<Pile>& out) {
    Search search(positions, within.members.size(), out);
    std::copy(within.members.begin(), within.members.end(), search.order().begin());
    const Bunch all = search.bunch(0, static_cast<std::uint32_t>(within.members.size()), 0);
    search.run({{all}, within.extent}, progress);
}

} // namespace process
