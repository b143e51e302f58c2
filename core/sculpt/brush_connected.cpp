#include "core/sculpt/brush_connected.h"

#include "core/base/cells.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

using base::Vec3f;

/// Cosine that normals of neighbours share at least: sharp edges are walked around, the far side is not reached.
constexpr float agreement = -0.2f;
/// Sine of the steepest way between neighbours: 60 degrees.
constexpr float steepest = 0.866f;

namespace {

struct CellPoint {
    Vec3f position, normal;
    std::uint32_t block;
    int slot;
    std::uint64_t cell;
};

/// The surfels under the brush by cells of a grid; those that have been reached leave it.
class Grid {
  public:
    Grid(const tree::SurfelTree& version, const Contact& from, float radius, float reach);

    std::vector<CellPoint> places; ///< sorted by cell

    /// Calls fn(index) for every surfel left in the cells around `p`; it leaves where fn returns true.
    template <class Fn>
    void takeAround(const Vec3f& p, const Fn& fn) {
        base::forCellsAround(base::cellOf(p, m_low, m_scale),
                             [&](const base::Cell& cell) { takeFrom(cell.key(), fn); });
    }

  private:
    struct Range {
        std::uint64_t key;
        std::size_t begin, end; ///< in m_left
    };
    void index();

    template <class Fn>
    void takeFrom(std::uint64_t key, const Fn& fn) {
        const std::uint32_t number = m_index.find(key, [this](std::uint32_t r) { return m_ranges[r].key; });
        if (number == base::KeyIndex::none)
            return;
        Range& range = m_ranges[number];
        for (std::size_t i = range.begin; i < range.end;)
            if (fn(m_left[i]))
                std::swap(m_left[i], m_left[--range.end]);
            else
                ++i;
    }

    Vec3f m_low;
    float m_scale;
    std::vector<std::size_t> m_left;
    std::vector<Range> m_ranges;
    base::KeyIndex m_index; ///< of the ranges
};

Grid::Grid(const tree::SurfelTree& version, const Contact& from, float radius, float reach) {
    m_low = from.position - Vec3f{radius, radius, radius};
    m_scale = 1 / std::max(reach, radius / 1e5f);
    const float radiusSq = radius * radius;
    version.forBlocksInBall(from.position, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3f p = block.position(slot);
            if (distanceSq(p, from.position) < radiusSq)
                places.push_back({p, block.normal(slot), number, slot, base::cellOf(p, m_low, m_scale).key()});
        }
    });
    std::stable_sort(places.begin(), places.end(),
                     [](const CellPoint& a, const CellPoint& b) { return a.cell < b.cell; });
    index();
}

void Grid::index() {
    for (std::size_t i = 0; i < places.size(); ++i) {
        m_left.push_back(i);
        if (m_ranges.empty() || m_ranges.back().key != places[i].cell)
            m_ranges.push_back({places[i].cell, i, i});
        ++m_ranges.back().end;
    }
    m_index.assign(static_cast<std::uint32_t>(m_ranges.size()), [this](std::uint32_t r) { return m_ranges[r].key; });
}

} // namespace

Connected::Connected(const tree::SurfelTree& version, const Contact& from, float radius, float reach) {
    Grid grid(version, from, radius, reach);
    const bool oriented = version.layout()->oriented;
    const auto neighbours = [&](const Vec3f& p, const Vec3f& n, const CellPoint& to) {
        const Vec3f way = to.position - p;
        const float distSq = lengthSq(way), facing = dot(n, to.normal);
        if (distSq > reach * reach || (oriented ? facing : std::abs(facing)) < agreement)
            return false;
        const float rise = std::max(std::abs(dot(way, n)), std::abs(dot(way, to.normal)));
        return rise * rise <= steepest * steepest * distSq;
    };
    std::vector<std::size_t> waiting;
    const auto walk = [&](const Vec3f& p, const Vec3f& n) {
        grid.takeAround(p, [&](std::size_t i) {
            const CellPoint& to = grid.places[i];
            if (!neighbours(p, n, to))
                return false;
            m_blocks[to.block].set(static_cast<std::size_t>(to.slot));
            ++m_count;
            waiting.push_back(i);
            return true;
        });
    };
    walk(from.position, from.normal);
    while (!waiting.empty()) {
        const CellPoint at = grid.places[waiting.back()];
        waiting.pop_back();
        walk(at.position, at.normal);
    }
}

} // namespace sculpt
