#include "core/process/estimation/graded_field.h"

#include <array>
#include <atomic>

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
            for (std::size_t k = begin; k < end; ++k)
                changed |= visit(first + (sweep % 2 ? end - 1 - (k - begin) : k), sweep);
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

    /// Whether nothing here can lie more than a slope apart, were all neighbours as near as the nearest, and those of
    /// the outer half as the nearest of these: rows are ascending but for what sees itself. Rounding is monotone, so
    /// that what is calm has nothing to lift; most rows are.
    bool isCalm(std::size_t i, const NeighbourGraph::Row& row) const {
        const std::size_t count = m_graph.count(), half = count / 2;
        for (std::size_t begin = 0, end = half; begin < count; begin = end, end = count) {
            if (begin == end)
                continue;
            const float drop = m_slope * m_graph.distance(i, row[begin]);
            for (const std::span<float> h : m_h) {
                const float own = std::atomic_ref(h[i]).load(std::memory_order_relaxed);
                float least = own, most = own;
                for (std::size_t k = begin; k < end; ++k) {
                    const float value = std::atomic_ref(h[row[k]]).load(std::memory_order_relaxed);
                    least = std::min(least, value), most = std::max(most, value);
                }
                if (!(own >= most - drop && least >= own - drop))
                    return false;
            }
        }
        return true;
    }

    bool visit(std::size_t i, unsigned sweep) {
        const NeighbourGraph::Row row = m_graph.row(i);
        const std::size_t count = m_graph.count();
        bool fresh = sweep == 0 || isFresh(i, sweep);
        for (std::size_t k = 0; k < count && !fresh; ++k)
            fresh = isFresh(row[k], sweep);
        if (!fresh || isCalm(i, row))
            return false;
        bool changed = false;
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t j = row[k];
            const float drop = m_slope * m_graph.distance(i, j);
            for (const std::span<float> h : m_h) {
                const float a = std::atomic_ref(h[i]).load(std::memory_order_relaxed);
                const float b = std::atomic_ref(h[j]).load(std::memory_order_relaxed);
                if (a < b - drop)
                    changed |= lift(h, i, b - drop, sweep);
                else if (b < a - drop)
                    changed |= lift(h, j, a - drop, sweep);
            }
        }
        return changed;
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
