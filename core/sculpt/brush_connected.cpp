#include "core/sculpt/brush_connected.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

using base::Vec3f;

/// Cosine that normals of neighbours share at least: sharp edges are walked around, the far side is not reached.
constexpr float agreement = -0.2f;
/// Sine of the steepest way between neighbours: 60 degrees.
constexpr float steepest = 0.866f;

namespace {

struct Place {
    Vec3f position, normal;
    std::uint32_t block;
    int slot;
    std::uint64_t cell;
};

/// The surfels under the brush by cells of a grid; those that have been reached leave it.
class Grid {
  public:
    Grid(const tree::SurfelTree& version, const Contact& from, float radius, float reach);

    std::vector<Place> places; ///< sorted by cell

    /// Calls fn(index) for every surfel left in the cells around `p`; it leaves where fn returns true.
    template <class Fn>
    void takeAround(const Vec3f& p, const Fn& fn) {
        const auto centre = cellOf(p);
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dz = -1; dz <= 1; ++dz)
                    takeFrom(keyOf({centre[0] + dx, centre[1] + dy, centre[2] + dz}), fn);
    }

  private:
    using Cell = std::array<std::int64_t, 3>;
    struct Range {
        std::uint64_t key;
        std::size_t begin, end; ///< in m_left
    };
    Cell cellOf(const Vec3f& p) const {
        const Vec3f at = (p - m_low) * m_scale;
        return {std::int64_t(std::floor(at.x)), std::int64_t(std::floor(at.y)), std::int64_t(std::floor(at.z))};
    }
    /// Cells of the ball lie within 0 to 2^20; one further is not asked for twice, so that 21 bits an axis do.
    static std::uint64_t keyOf(const Cell& c) {
        return std::uint64_t(c[0] + 1) << 42 | std::uint64_t(c[1] + 1) << 21 | std::uint64_t(c[2] + 1);
    }
    std::size_t home(std::uint64_t key) const { return (key * 0x9E3779B97F4A7C15u >> 20) & (m_table.size() - 1); }
    void index();

    template <class Fn>
    void takeFrom(std::uint64_t key, const Fn& fn) {
        for (std::size_t at = home(key); m_table[at]; at = (at + 1) & (m_table.size() - 1)) {
            Range& range = m_ranges[m_table[at] - 1];
            if (range.key != key)
                continue;
            for (std::size_t i = range.begin; i < range.end;)
                if (fn(m_left[i]))
                    std::swap(m_left[i], m_left[--range.end]);
                else
                    ++i;
            return;
        }
    }

    Vec3f m_low;
    float m_scale;
    std::vector<std::size_t> m_left;
    std::vector<Range> m_ranges;
    std::vector<std::size_t> m_table; ///< open addressing: 1 + index of a range, 0 where free
};

Grid::Grid(const tree::SurfelTree& version, const Contact& from, float radius, float reach) {
    m_low = from.position - Vec3f{radius, radius, radius};
    m_scale = 1 / std::max(reach, radius / 1e5f);
    const float radiusSq = radius * radius;
    version.forBlocksInBall(from.position, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot) {
            const Vec3f p = block.position(slot);
            if (distanceSq(p, from.position) < radiusSq)
                places.push_back({p, block.normal(slot), number, slot, keyOf(cellOf(p))});
        }
    });
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.cell < b.cell; });
    index();
}

void Grid::index() {
    for (std::size_t i = 0; i < places.size(); ++i) {
        m_left.push_back(i);
        if (m_ranges.empty() || m_ranges.back().key != places[i].cell)
            m_ranges.push_back({places[i].cell, i, i});
        ++m_ranges.back().end;
    }
    std::size_t size = 16;
    while (size < 2 * m_ranges.size())
        size *= 2;
    m_table.assign(size, 0);
    for (std::size_t i = 0; i < m_ranges.size(); ++i) {
        std::size_t at = home(m_ranges[i].key);
        while (m_table[at])
            at = (at + 1) & (size - 1);
        m_table[at] = i + 1;
    }
}

} // namespace

Connected::Connected(const tree::SurfelTree& version, const Contact& from, float radius, float reach) {
    Grid grid(version, from, radius, reach);
    const bool oriented = version.layout()->oriented;
    const auto neighbours = [&](const Vec3f& p, const Vec3f& n, const Place& to) {
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
            const Place& to = grid.places[i];
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
        const Place at = grid.places[waiting.back()];
        waiting.pop_back();
        walk(at.position, at.normal);
    }
}

} // namespace sculpt
