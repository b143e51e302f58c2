// A packet of neighbouring rays: the clusters that any of them may meet are collected once, then every ray looks
// through them 16 boxes at a time. For kernels that are compiled once per instruction set.
#if defined(POINTCLAY_DISC_BEAM_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_DISC_BEAM_H
#undef POINTCLAY_DISC_BEAM_H
#else
#define POINTCLAY_DISC_BEAM_H
#endif

#include "core/surface/disc_search.h"

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Slabs of all rays at once, by interval arithmetic.
class BeamSlabs {
  public:
    BeamSlabs(std::span<const base::Rayf> rays, const Slabs* slabs, float far) {
        for (std::size_t k = 0; k < 3; ++k) {
            Axis& axis = m_axes[k];
            float least = DiscHit::none, most = -DiscHit::none; // directions
            for (std::size_t i = 0; i < rays.size(); ++i) {
                axis.originLo = std::min(axis.originLo, rays[i].origin[k]);
                axis.originHi = std::max(axis.originHi, rays[i].origin[k]);
                axis.inverseLo = std::min(axis.inverseLo, slabs[i].inverse[k]);
                axis.inverseHi = std::max(axis.inverseHi, slabs[i].inverse[k]);
                least = std::min(least, rays[i].direction[k]);
                most = std::max(most, rays[i].direction[k]);
            }
            axis.pathLo = axis.originLo + std::min(0.0f, least) * far;
            axis.pathHi = axis.originHi + std::max(0.0f, most) * far;
        }
    }

    /// Lanes that some ray may meet at t in [least, most], and the least t at which one may enter.
    unsigned meeting(const surfel::BoundsLanes& lanesOf, float least, float most, float* HWY_RESTRICT enter) const {
        const hn::CappedTag<float, surfel::laneCount> d;
        const BoundsArrays bounds(lanesOf);
        const int width = static_cast<int>(hn::Lanes(d));
        unsigned out = 0;
        for (int first = 0; first < surfel::laneCount; first += width) {
            const auto reach = hn::Mul(hn::Load(d, bounds.support + first), hn::Set(d, surfel::surfaceReach));
            auto begin = hn::Set(d, least * early), end = hn::Set(d, most);
            auto met = hn::Eq(begin, begin);
            for (int k = 0; k < 3; ++k) {
                const Axis& axis = m_axes[k];
                const auto lo = hn::Sub(hn::Load(d, bounds.lo[k] + first), reach);
                const auto hi = hn::Add(hn::Load(d, bounds.hi[k] + first), reach);
                // rays that run both ways along this axis stay between the ends of their paths
                met = hn::And(met, hn::And(hn::Le(lo, hn::Set(d, axis.pathHi)), hn::Ge(hi, hn::Set(d, axis.pathLo))));
                if (axis.inverseLo < 0 && axis.inverseHi > 0)
                    continue;
                const auto i0 = hn::Set(d, axis.inverseLo), i1 = hn::Set(d, axis.inverseHi);
                const auto below = hn::Sub(lo, hn::Set(d, axis.originHi)),
                           above = hn::Sub(hi, hn::Set(d, axis.originLo));
                const auto in = axis.inverseLo > 0 ? below : above, away = axis.inverseLo > 0 ? above : below;
                begin = hn::Max(begin, hn::Mul(hn::Min(hn::Mul(in, i0), hn::Mul(in, i1)), hn::Set(d, early)));
                end = hn::Min(end, hn::Mul(hn::Max(hn::Mul(away, i0), hn::Mul(away, i1)), hn::Set(d, late)));
            }
            hn::Store(begin, d, enter + first);
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, hn::And(met, hn::Le(begin, end)), bits);
            out |= static_cast<unsigned>(bits[0]) << first;
        }
        return out;
    }

  private:
    static constexpr float early = 0.99999f, late = 1.00001f; ///< more than what single rays allow for rounding

    struct Axis {
        float originLo = DiscHit::none, originHi = -DiscHit::none, inverseLo = DiscHit::none,
              inverseHi = -DiscHit::none;
        float pathLo = 0, pathHi = 0;
    };
    Axis m_axes[3];
};

class DiscBeam {
  public:
    static constexpr std::size_t most = 16; ///< rays

    /// False where the rays have too little in common; they are then better walked one by one. REQUIRES: at most
    /// `most`.
    bool collect(const tree::Node& root, std::span<const base::Rayf> rays, const DiscRange& range) {
        if (!alike(rays))
            return false;
        m_count = 0;
        std::transform(rays.begin(), rays.end(), m_slabs, [](const base::Rayf& ray) { return Slabs(ray); });
        const BeamSlabs slabs(rays, m_slabs, farthest(root, rays, range));
        return collectFrom(root, slabs, range);
    }

    /// What a walk of every ray would find.
    void run(std::span<const base::Rayf> rays, const DiscRange& range, DiscHit* out) {
        arrange();
        for (std::size_t i = 0; i < rays.size(); ++i)
            out[i] = runOne(rays[i], m_slabs[i], range);
    }

  private:
    static constexpr std::size_t capacity = 128, groupSize = 7 * lanes;

    /// Do the rays go about the same way?
    static bool alike(std::span<const base::Rayf> rays) {
        constexpr float spread = 0.2f; // of directions
        for (const base::Rayf& ray : rays)
            if (lengthSq(ray.direction - rays[0].direction) > spread * spread)
                return false;
        return true;
    }
    /// No ray is in the model's bounds at larger t.
    static float farthest(const tree::Node& root, std::span<const base::Rayf> rays, const DiscRange& range) {
        base::Box3f box;
        for (int i = 0; i < root.childCount; ++i)
            box.extend(root.box(i));
        for (const base::Rayf& ray : rays)
            box.extend(ray.origin);
        return std::min(range.tMax, 1.001f * (box.diagonal() + 2 * range.maxSupport));
    }

    bool collectFrom(const tree::Node& node, const BeamSlabs& slabs, const DiscRange& range) {
        HWY_ALIGN float enter[surfel::laneCount];
        unsigned mask = slabs.meeting(node, range.tMin, range.tMax, enter) & node.childMask();
        for (; mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(mask));
            if (!(node.level == 1 ? collectBlock(*node.blocks[i], slabs, range)
                                  : collectFrom(*node.nodes[i], slabs, range)))
                return false;
        }
        return true;
    }
    bool collectBlock(const surfel::SurfelBlock& block, const BeamSlabs& slabs, const DiscRange& range) {
        HWY_ALIGN float enter[surfel::laneCount];
        unsigned mask = slabs.meeting(block.boundsLanes(), range.tMin, range.tMax, enter) & block.clusterMask();
        for (; mask != 0; mask &= mask - 1) {
            const int i = std::countr_zero(mask);
            if (m_count == capacity)
                return false;
            m_found[m_count++] = {enter[i], i, &block};
        }
        return true;
    }

    /// Front to back, with their bounds in groups of 16.
    void arrange() {
        std::sort(m_found, m_found + m_count, [](const Found& a, const Found& b) { return a.enter < b.enter; });
        for (std::size_t i = 0; i < m_count; ++i) {
            const surfel::ClusterBounds bounds = m_found[i].block->bounds(m_found[i].cluster);
            float* at = m_bounds + i / lanes * groupSize + i % lanes;
            for (std::size_t k = 0; k < 3; ++k) {
                at[k * lanes] = bounds.box.lo[k];
                at[(3 + k) * lanes] = bounds.box.hi[k];
            }
            at[6 * lanes] = bounds.maxSupport;
            m_clusters[i] = m_found[i].block->channel(m_found[i].cluster, surfel::X);
        }
        for (std::size_t i = m_count; i % lanes != 0; ++i)
            for (std::size_t k = 0; k < 7; ++k)
                m_bounds[i / lanes * groupSize + k * lanes + i % lanes] = 0; // masked later
    }

    DiscHit runOne(const base::Rayf& ray, const Slabs& slabs, const DiscRange& range) {
        m_search.start(ray, range);
        for (std::size_t first = 0; first < m_count && m_found[first].enter <= m_search.most(); first += lanes) {
            HWY_ALIGN float enter[lanes];
            unsigned mask = meeting<lanes>(BoundsArrays(m_bounds + first / lanes * groupSize), slabs, range.tMin,
                                           m_search.most(), enter);
            if (m_count - first < lanes)
                mask &= (1u << (m_count - first)) - 1;
            for (; mask != 0; mask &= mask - 1) {
                const auto i = static_cast<std::size_t>(std::countr_zero(mask));
                if (enter[i] <= m_search.most())
                    m_search.open(m_clusters[first + i]);
            }
        }
        return m_search.finish();
    }

    struct Found {
        float enter;
        int cluster;
        const surfel::SurfelBlock* block;
    };

    Slabs m_slabs[most];
    DiscSearch m_search;
    std::size_t m_count = 0;
    Found m_found[capacity];
    const float* m_clusters[capacity];
    HWY_ALIGN float m_bounds[capacity / lanes * groupSize];
};

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
