// A packet of neighbouring rays walks the tree together, front to back: it opens the nodes and blocks that any of them
// may meet, then tests a cluster's box against 16 rays at a time. For kernels that are compiled once per instruction
// set.
#if defined(POINTCLAY_DISC_BEAM_H) == defined(HWY_TARGET_TOGGLE)
#ifdef POINTCLAY_DISC_BEAM_H
#undef POINTCLAY_DISC_BEAM_H
#else
#define POINTCLAY_DISC_BEAM_H
#endif

#include "core/surface/rays/disc_search.h"

#include <hwy/cache_control.h>

#include <cassert>

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
    static constexpr std::size_t most = lanes; ///< rays

    /// False where the rays have too little in common; they are then better walked one by one. REQUIRES: at most
    /// `most`.
    static bool alike(std::span<const base::Rayf> rays) {
        constexpr float spread = 0.2f; // of directions
        for (const base::Rayf& ray : rays)
            if (lengthSq(ray.direction - rays[0].direction) > spread * spread)
                return false;
        return true;
    }

    /// What a walk of every ray would find; a bit for each that must be looked for again, widely.
    unsigned run(const tree::Node& root, std::span<const base::Rayf> rays, const DiscRange& range, DiscHit* out) {
        start(rays, range);
        const BeamSlabs slabs(rays, m_slabs, farthest(root, rays, range));
        m_count = 0;
        m_stack[m_count++] = {range.tMin, root.level, &root};
        while (m_count > 0) {
            const Entry next = m_stack[--m_count];
            if (next.enter > m_most)
                continue;
            if (next.kind == isBlock)
                openBlock(*static_cast<const surfel::SurfelBlock*>(next.what), slabs, range.tMin);
            else
                openNode(*static_cast<const tree::Node*>(next.what), slabs, range.tMin);
        }
        unsigned again = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            again |= m_searches[i].complete() ? 0 : 1u << i;
            out[i] = m_searches[i].finish();
        }
        return again;
    }

  private:
    static constexpr int isBlock = 0; ///< kind of entries; nodes have their level
    struct Entry {
        float enter;
        int kind;
        const void* what;
    };

    void start(std::span<const base::Rayf> rays, const DiscRange& range) {
        m_most = range.tMax;
        for (std::size_t i = 0; i < most; ++i) {
            const bool used = i < rays.size();
            m_ends[i] = used ? range.tMax : -1; // the others meet nothing
            if (used) {
                m_slabs[i] = Slabs(rays[i]);
                m_searches[i].start(rays[i], range);
            }
            for (std::size_t k = 0; k < 3; ++k) {
                m_origins[k * lanes + i] = used ? m_slabs[i].origin[k] : 0;
                m_inverses[k * lanes + i] = used ? m_slabs[i].inverse[k] : 1;
            }
        }
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

    /// The nearest child comes to lie on top.
    void openNode(const tree::Node& node, const BeamSlabs& slabs, float least) {
        HWY_ALIGN float enter[surfel::laneCount];
        unsigned mask = slabs.meeting(node, least, m_most, enter) & node.childMask();
        const std::size_t bottom = m_count;
        assert(m_count + surfel::laneCount <= std::size(m_stack));
        for (; mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(mask));
            const bool blocks = node.level == 1;
            const void* child =
                blocks ? static_cast<const void*>(node.blocks[i].get()) : static_cast<const void*>(node.nodes[i].get());
            prefetch(child, 5);
            std::size_t at = m_count++;
            for (; at > bottom && m_stack[at - 1].enter < enter[i]; --at)
                m_stack[at] = m_stack[at - 1];
            m_stack[at] = {enter[i], blocks ? isBlock : node.level - 1, child};
        }
    }

    /// All clusters that some ray meets are asked for before the first is opened.
    void openBlock(const surfel::SurfelBlock& block, const BeamSlabs& slabs, float least) {
        HWY_ALIGN float enter[surfel::laneCount];
        unsigned mask = slabs.meeting(block.boundsLanes(), least, m_most, enter) & block.clusterMask();
        unsigned rays[surfel::laneCount], met = 0;
        for (; mask != 0; mask &= mask - 1) {
            const int i = std::countr_zero(mask);
            rays[i] = raysMeeting(block.boundsLanes(), i, least);
            if (rays[i] != 0) {
                met |= 1u << i;
                prefetch(block.channel(i, surfel::X), 7);
            }
        }
        if (met == 0)
            return;
        for (; met != 0; met &= met - 1) {
            const int i = std::countr_zero(met);
            openCluster(block.channel(i, surfel::X), rays[i]);
        }
        m_most = latestEnd();
    }
    void openCluster(const float* cluster, unsigned rays) {
        const D d;
        for (int first = 0; first < lanes; first += static_cast<int>(hn::Lanes(d))) {
            const Discs discs = Discs::load(d, cluster, first);
            for (unsigned left = rays; left != 0; left &= left - 1) {
                const auto ray = static_cast<std::size_t>(std::countr_zero(left));
                m_searches[ray].meet(cluster, discs);
                m_ends[ray] = m_searches[ray].most();
            }
        }
    }

    /// Those that meet the bound of a cluster before their end: as `meeting`, with rays in the lanes.
    unsigned raysMeeting(const surfel::BoundsLanes& bounds, int cluster, float least) const {
        const D d;
        const int width = static_cast<int>(hn::Lanes(d));
        const float reach = bounds.maxSupport[cluster] * surfel::surfaceReach;
        const float lo[3] = {bounds.loX[cluster] - reach, bounds.loY[cluster] - reach, bounds.loZ[cluster] - reach};
        const float hi[3] = {bounds.hiX[cluster] + reach, bounds.hiY[cluster] + reach, bounds.hiZ[cluster] + reach};
        unsigned out = 0;
        for (int first = 0; first < lanes; first += width) {
            V begin = hn::Zero(d), end = hn::Set(d, std::numeric_limits<float>::max());
            for (int k = 0; k < 3; ++k) {
                const V origin = hn::Load(d, m_origins + k * lanes + first),
                        inverse = hn::Load(d, m_inverses + k * lanes + first);
                const V a = hn::Mul(hn::Sub(hn::Set(d, lo[k]), origin), inverse);
                const V b = hn::Mul(hn::Sub(hn::Set(d, hi[k]), origin), inverse);
                begin = hn::Max(begin, hn::Min(a, b));
                end = hn::Min(end, hn::Max(a, b));
            }
            begin = hn::Max(hn::Mul(begin, hn::Set(d, earlyBy)), hn::Set(d, least));
            end = hn::Min(hn::Mul(end, hn::Set(d, lateBy)), hn::Load(d, m_ends + first));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(d, hn::Le(begin, end), bits);
            out |= (bits[0] | static_cast<unsigned>(bits[1]) << 8) << first;
        }
        return out;
    }

    float latestEnd() const {
        const D d;
        V out = hn::Load(d, m_ends);
        for (int first = static_cast<int>(hn::Lanes(d)); first < lanes; first += static_cast<int>(hn::Lanes(d)))
            out = hn::Max(out, hn::Load(d, m_ends + first));
        return hn::GetLane(hn::MaxOfLanes(d, out));
    }

    static void prefetch(const void* from, int lines) {
        for (int i = 0; i < lines; ++i)
            hwy::Prefetch(static_cast<const char*>(from) + 64 * i);
    }

    HWY_ALIGN float m_origins[3 * lanes], m_inverses[3 * lanes];
    HWY_ALIGN float m_ends[lanes]; ///< of each ray's search
    float m_most = 0;              ///< the latest of them
    Slabs m_slabs[most];
    DiscSearch m_searches[most];
    std::size_t m_count = 0;
    Entry m_stack[16 * surfel::laneCount]; ///< a walk leaves at most 7 entries on each level of the tree
};

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#endif
