#include "core/process/estimation/graded_field.h"

#include "core/process/estimation/graded_row.h"

#include <array>
#include <atomic>
#include <bit>

namespace process {

namespace {

/// Fields that rise together, over the same neighbours: distances are the larger part of the work.
template <std::size_t fields>
class Rising {
  public:
    Rising(std::array<std::span<float>, fields> h, const NeighbourGraph& graph, float slope)
        : m_h(h), m_graph(graph), m_slope(slope), m_changed(graph.size()) {}

    /// Raises what lies more than a slope below a neighbour until nothing does, along the curve there and back.
    void run(const base::Progress& progress) {
        std::fill(m_changed.begin(), m_changed.end(), std::uint8_t(never));
        bool changed = true;
        for (unsigned sweep = 0; changed; ++sweep) {
            const double done = 1 - 1 / (1 + 0.2 * sweep); // nobody knows how many there will be
            changed = false;
            for (std::size_t s = 0; s < slabs(); ++s) {
                progress.step(done, "Grading supports");
                changed |= sweepSlab(sweep % 2 ? slabs() - 1 - s : s, sweep);
            }
        }
    }

  private:
    static constexpr std::size_t slab = 1 << 19, grain = 1 << 13;
    /// Sweeps are counted to 256 and begin again; what changed so long ago is looked at in vain.
    static constexpr unsigned never = 128;
    std::size_t slabs() const { return base::chunkCount(m_graph.size(), slab); }

    bool sweepSlab(std::size_t number, unsigned sweep) {
        const std::size_t first = number * slab, size = std::min(slab, m_graph.size() - first);
        std::atomic<bool> any = false;
        base::parallelChunks(size, grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            bool changed = false;
            GradedRow lanes;
            for (std::size_t k = begin; k < end; ++k)
                changed |= visit(first + (sweep % 2 ? end - 1 - (k - begin) : k), sweep, lanes);
            if (changed)
                any.store(true, std::memory_order_relaxed);
        });
        return any;
    }

    /// Since the sweep before: what changed there before this row was looked at, it has seen already.
    bool isFresh(std::size_t i, unsigned sweep) {
        const std::uint8_t changed = std::atomic_ref(m_changed[i]).load(std::memory_order_relaxed);
        return changed == std::uint8_t(sweep) || changed == std::uint8_t(sweep - 1);
    }

    bool visit(std::size_t i, unsigned sweep, GradedRow& lanes) {
        const NeighbourGraph::Row row = m_graph.row(i);
        const std::size_t count = m_graph.count();
        bool fresh = sweep == 0 || isFresh(i, sweep);
        for (std::size_t k = 0; k < count && !fresh; ++k)
            fresh = isFresh(row[k], sweep);
        if (!fresh)
            return false;
        take(i, row, lanes);
        judgeRow(lanes, count, fields, m_slope);
        bool changed = false;
        for (std::size_t f = 0; f < fields; ++f) {
            const float wanted = lanes.wanted[f];
            if (lanes.own[f] < wanted)
                changed |= lift(m_h[f], i, wanted, sweep);
            for (std::uint32_t below = lanes.below[f]; below != 0; below &= below - 1) {
                const auto k = static_cast<std::size_t>(std::countr_zero(below));
                changed |= lift(m_h[f], row[k], wanted - lanes.drop[k], sweep);
            }
        }
        return changed;
    }

    void take(std::size_t i, const NeighbourGraph::Row& row, GradedRow& out) const {
        const std::span<const base::Vec3f> positions = m_graph.positions();
        const std::size_t count = m_graph.count();
        out.position = positions[i];
        for (std::size_t k = 0; k < count; ++k) {
            const base::Vec3f& p = positions[row[k]];
            out.x[k] = p.x, out.y[k] = p.y, out.z[k] = p.z;
        }
        for (std::size_t f = 0; f < fields; ++f) {
            out.own[f] = std::atomic_ref(m_h[f][i]).load(std::memory_order_relaxed);
            for (std::size_t k = 0; k < count; ++k)
                out.value[f][k] = std::atomic_ref(m_h[f][row[k]]).load(std::memory_order_relaxed);
        }
    }

    /// Another thread may have raised it meanwhile, higher even.
    bool lift(std::span<float> h, std::size_t i, float to, unsigned sweep) {
        const std::atomic_ref<float> value(h[i]);
        float seen = value.load(std::memory_order_relaxed);
        while (seen < to)
            if (value.compare_exchange_weak(seen, to, std::memory_order_relaxed)) {
                std::atomic_ref(m_changed[i]).store(std::uint8_t(sweep), std::memory_order_relaxed);
                return true;
            }
        return false;
    }

    std::array<std::span<float>, fields> m_h;
    const NeighbourGraph& m_graph;
    float m_slope;
    base::LargeArray<std::uint8_t> m_changed; ///< the last sweep in which each was raised
};

} // namespace

void raise(std::vector<float>& h, const NeighbourGraph& graph, float slope, const base::Progress& progress) {
    Rising<1>({h}, graph, slope).run(progress);
}

void grade(std::vector<float>& h, const NeighbourGraph& graph, float slope, const base::Progress& progress) {
    std::vector<float> below(h.size());
    base::parallelFor(h.size(), 1 << 14, [&](std::size_t i) { below[i] = -h[i]; });
    Rising<2>({h, below}, graph, slope).run(progress);
    base::parallelFor(h.size(), 1 << 14, [&](std::size_t i) { h[i] = 0.5f * (h[i] - below[i]); });
}

} // namespace process
