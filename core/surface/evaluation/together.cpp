#include "core/surface/evaluation/together.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/kernels/self_kernel.h"
#include "core/surface/evaluation/near_sheets.h"
#include "core/surface/evaluation/position_order.h"
#include "core/surface/evaluation/source.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace surface {

namespace {

constexpr std::size_t lanes = SelfLanes::lanes;
constexpr std::size_t positionsPerTask = 16 * lanes;
/// Positions that come this close to a limit of the assembler's are left to it.
constexpr float clearly = 1.001f;

/// Positions for which blocks are collected at once, and blocks above which they are parted.
constexpr std::size_t collectedFor = 64, mostBlocks = 48;
/// So many clusters are a fair price for what these positions share.
constexpr std::size_t fairClusters(std::size_t positions) {
    return 16 + positions;
}

TogetherAt plainAt(const Evaluationf& e, const base::Vec3f& x) {
    const base::Vec3f off = x - e.centroid;
    return {e.status,   e.value,   e.unit, e.offCentre, e.agreement, dot(off, e.normalGradient * off),
            e.centroid, e.gradient};
}

TogetherAt plainAt(const SelfLanes& at, int lane) {
    return {at.status[lane],    at.value[lane], at.unit[lane],       at.offCentre[lane],
            at.agreement[lane], at.bend[lane],  at.centroidAt(lane), at.gradientAt(lane)};
}

/// One thread's part of a batch.
class Together {
  public:
    Together(const Surface& surface, std::span<const base::Vec3f> x, std::span<const base::Vec3f> hints,
             std::span<TogetherAt> out)
        : m_surface(surface), m_plain(surface), m_single(surface), m_x(x), m_hints(hints), m_out(out) {}

    /// Puts them in another order on the way.
    void evaluate(std::span<std::uint32_t> which) {
        for (; m_plain.applies() && !which.empty(); which = which.subspan(std::min(collectedFor, which.size())))
            part(which.first(std::min(collectedFor, which.size())), false);
        for (const std::uint32_t i : which)
            evaluateSingly(i);
    }

  private:
    /// Halves them until 16 lie together. `collected`: what lies around all of them is known.
    void part(std::span<std::uint32_t> which, bool collected) {
        const std::size_t count = which.size();
        if (!collected) {
            collected =
                m_candidates.findBlocks(m_surface, boxOf(m_x, which), count > 1 ? mostBlocks : Candidates::anyNumber);
            if (collected)
                m_candidates.fetchClusters();
        }
        if (count <= lanes && collected && select(which) <= fairClusters(count))
            return evaluateLanes(which);
        if (count == 1)
            return evaluateLanes(which);
        const std::size_t all = m_near.size(), half = halve(which);
        const auto first = which.first(half), second = which.subspan(half);
        if (count <= lanes && collected && select(first) + select(second) >= all) {
            select(which);
            return evaluateLanes(which);
        }
        part(first, collected);
        part(second, collected);
    }
    /// By the longest axis of their box, at a multiple of 16 where there are more; returns where.
    std::size_t halve(std::span<std::uint32_t> which) const {
        const base::Vec3f size = boxOf(m_x, which).size();
        const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::size_t middle = which.size() / 2, half = middle > lanes ? middle / lanes * lanes : middle;
        std::nth_element(which.begin(), which.begin() + static_cast<std::ptrdiff_t>(half), which.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return keyOf(a, axis) < keyOf(b, axis); });
        return half;
    }
    float keyOf(std::uint32_t i, std::size_t axis) const {
        return std::isnan(m_x[i][axis]) ? std::numeric_limits<float>::infinity() : m_x[i][axis];
    }
    /// Of what was collected, the clusters that may have weight at these; returns how many.
    std::size_t select(std::span<const std::uint32_t> which) {
        m_box = boxOf(m_x, which);
        m_near.clear();
        m_candidates.select(m_box, m_near);
        return m_near.size();
    }

    void evaluateLanes(std::span<const std::uint32_t> which) {
        alignas(64) float place[3][lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane)
            for (std::size_t k = 0; k < 3; ++k)
                place[k][lane] = m_x[which[std::min(lane, which.size() - 1)]][k];
        const SelfInput in{place[0],
                           m_box,
                           m_near.span(),
                           m_plain.weight(),
                           m_plain.supportScale(),
                           m_plain.mu(),
                           m_plain.boundaryLimit(),
                           clearly * static_cast<float>(oneSheetBelow),
                           clearly * static_cast<float>(leastSpread),
                           true,
                           true,
                           m_plain.shape()};
        const unsigned special = selfKernel(in, m_scratch.rows(selfRows(in.shape > 0), m_near.size()), m_at);
        for (std::size_t lane = 0; lane < which.size(); ++lane)
            if (special >> lane & 1)
                evaluateSingly(which[lane]);
            else {
                m_at.status[lane] = m_plain.settled(m_at.status[lane], m_x[which[lane]]);
                m_out[which[lane]] = plainAt(m_at, static_cast<int>(lane));
            }
    }

    void evaluateSingly(std::uint32_t i) {
        m_single.evaluate(m_x[i], Need::Gradient, {m_hints[i]}, m_evaluation);
        m_out[i] = plainAt(m_evaluation, m_x[i]);
    }

    const Surface& m_surface;
    SummedNormals m_plain;
    Source m_single;
    std::span<const base::Vec3f> m_x, m_hints;
    std::span<TogetherAt> m_out;
    base::Box3f m_box;
    Candidates m_candidates;
    ClusterList m_near;
    PickScratch m_scratch;
    SelfLanes m_at;
    Evaluationf m_evaluation;
};

} // namespace

void evaluateTogether(const Surface& surface, std::span<const base::Vec3f> x, std::span<const base::Vec3f> hints,
                      std::span<TogetherAt> out) {
    assert(x.size() == hints.size() && x.size() == out.size());
    if (x.empty())
        return;
    std::vector<std::uint32_t> order = packetOrder(surface, x, lanes);
    base::parallelChunks(x.size(), positionsPerTask, [&](std::size_t begin, std::size_t end, std::size_t) {
        Together(surface, x, hints, out).evaluate({order.data() + begin, end - begin});
    });
}

} // namespace surface
