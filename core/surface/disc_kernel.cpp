// The walk to the nearest disc, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/disc_kernel.cpp"
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include "core/surface/disc_kernel.h"

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After the main header.
#include "core/surface/disc_lanes.h"

#include <cassert>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Of the support, along the ray: how far behind a nearest disc that faces along the ray another matters.
constexpr float window = 0.7f;

/// One ray's walk, in steps so that several can be under way: each ends by asking for the memory of the next.
class Walk {
  public:
    void start(const tree::Node& root, const base::Rayf& ray, float tMin, float tMax) {
        m_ray = ray;
        m_slabs = Slabs(ray);
        m_least = tMin;
        m_most = tMax;
        m_hit = {};
        m_cluster = nullptr;
        m_stack[0] = {tMin, root.level, &root};
        m_count = 1;
    }

    /// Opens the nearest of what is left; false when nothing is.
    bool step() {
        while (m_count > 0) {
            const Entry next = m_stack[--m_count];
            if (next.enter > m_most)
                continue;
            if (next.kind > isBlock)
                openNode(*static_cast<const tree::Node*>(next.what));
            else if (next.kind == isBlock)
                openBlock(*static_cast<const surfel::SurfelBlock*>(next.what));
            else
                openCluster(static_cast<const float*>(next.what));
            if (m_count > 0)
                prefetch(m_stack[m_count - 1]);
            return true;
        }
        return false;
    }

    DiscHit finish() {
        if (m_cluster)
            blend();
        // of no account once something is crossed before it
        if (!(m_hit.brushFirst < m_hit.nearest))
            m_hit.brushFirst = m_hit.brushLast = DiscHit::none;
        else
            m_hit.brushLast = std::min(m_hit.brushLast, m_hit.nearest);
        return m_hit;
    }

  private:
    static constexpr int isBlock = 0, isCluster = -1; ///< kinds of entries; nodes have their level
    struct Entry {
        float enter;
        int kind;
        const void* what;
    };

    static void prefetch(const Entry& entry) {
        const char* from = static_cast<const char*>(entry.what);
        const int lines = entry.kind == isCluster ? 7 : 5;
        for (int i = 0; i < lines; ++i)
            hwy::Prefetch(from + 64 * i);
    }

    /// The nearest comes to lie on top.
    template <class Child>
    void push(unsigned mask, const float* enter, int kind, const Child& child) {
        const std::size_t bottom = m_count;
        assert(m_count + surfel::laneCount <= std::size(m_stack));
        for (; mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(mask));
            std::size_t at = m_count++;
            for (; at > bottom && m_stack[at - 1].enter < enter[i]; --at)
                m_stack[at] = m_stack[at - 1];
            m_stack[at] = {enter[i], kind, child(i)};
        }
    }

    void openNode(const tree::Node& node) {
        HWY_ALIGN float enter[surfel::laneCount];
        const unsigned mask = meeting(node, m_slabs, m_least, m_most, enter) & node.childMask();
        if (node.level == 1)
            push(mask, enter, isBlock, [&](std::size_t i) -> const void* { return node.blocks[i].get(); });
        else
            push(mask, enter, node.level - 1, [&](std::size_t i) -> const void* { return node.nodes[i].get(); });
    }
    void openBlock(const surfel::SurfelBlock& block) {
        HWY_ALIGN float enter[surfel::laneCount];
        const unsigned mask = meeting(block.boundsLanes(), m_slabs, m_least, m_most, enter) & block.clusterMask();
        push(mask, enter, isCluster,
             [&](std::size_t i) -> const void* { return block.channel(static_cast<int>(i), surfel::X); });
    }

    void openCluster(const float* c) {
        const D d;
        const int width = static_cast<int>(hn::Lanes(d));
        const V none = hn::Set(d, DiscHit::none);
        for (int first = 0; first < lanes; first += width) {
            const Crossings found = cross(d, c + first, m_ray);
            const M ahead = hn::And(hn::Ge(found.t, hn::Set(d, m_least)), hn::Le(found.t, hn::Set(d, m_most)));
            const M crossed = hn::And(found.crossed, ahead), brushed = hn::And(found.brushed, ahead);
            if (HWY_UNLIKELY(!hn::AllFalse(d, brushed)))
                noteBrushed(d, brushed, found);
            if (hn::AllFalse(d, crossed))
                continue;
            const M against = hn::And(crossed, hn::Lt(found.slope, hn::Zero(d)));
            m_hit.facing =
                std::min(m_hit.facing, hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(against, found.t, none))));
            const V t = hn::IfThenElse(crossed, found.t, none), least = hn::MinOfLanes(d, t);
            if (hn::GetLane(least) < m_hit.nearest)
                noteNearest(d, static_cast<std::size_t>(hn::FindFirstTrue(d, hn::Eq(t, least))), found, c);
        }
    }

    void noteBrushed(D d, M brushed, const Crossings& found) {
        const auto first = static_cast<std::size_t>(hn::FindFirstTrue(d, brushed));
        const float from = hn::GetLane(hn::MinOfLanes(d, hn::IfThenElse(brushed, found.t, hn::Set(d, DiscHit::none))));
        const float to = hn::GetLane(hn::MaxOfLanes(d, hn::IfThenElse(brushed, found.t, hn::Set(d, -DiscHit::none))));
        m_hit.brushLast = m_hit.brushed() ? std::max(m_hit.brushLast, to) : to;
        m_hit.brushFirst = std::min(m_hit.brushFirst, from);
        if (!m_hit.crossed())
            m_hit.support = lane(d, found.support, first);
    }

    void noteNearest(D d, std::size_t i, const Crossings& found, const float* cluster) {
        m_hit.nearest = lane(d, found.t, i);
        m_hit.cosine = lane(d, found.slope, i);
        m_hit.support = lane(d, found.support, i);
        m_cluster = cluster;
        m_most = std::min(m_most, m_hit.nearest + (m_hit.cosine < 0 ? 0.0f : window * m_hit.support));
    }

    static float lane(D d, V v, std::size_t i) {
        HWY_ALIGN float values[lanes];
        hn::Store(v, d, values);
        return values[i];
    }

    /// Crossings of the cluster's discs that face like the nearest, most weight to the discs crossed near their centre:
    /// closer to the surface than the nearest disc by an order.
    void blend() {
        const D d;
        const int width = static_cast<int>(hn::Lanes(d));
        const V most = hn::Set(d, 0.5f * m_hit.support);
        HWY_ALIGN float weights[lanes], offsets[lanes];
        for (int first = 0; first < lanes; first += width) {
            const Crossings found = cross(d, m_cluster + first, m_ray);
            const V offset = hn::Sub(found.t, hn::Set(d, m_hit.nearest));
            const M alike = hn::Gt(hn::Mul(found.slope, hn::Set(d, m_hit.cosine)), hn::Zero(d));
            const M used = hn::And(hn::And(found.crossed, alike), hn::Lt(hn::Abs(offset), most));
            hn::Store(hn::IfThenElseZero(used, found.weight), d, weights + first);
            hn::Store(hn::IfThenElseZero(used, hn::Mul(found.weight, offset)), d, offsets + first);
        }
        const float total = sumOf(weights);
        m_hit.guess = total > 0 ? m_hit.nearest + sumOf(offsets) / total : m_hit.nearest;
    }

    base::Rayf m_ray;
    Slabs m_slabs;
    float m_least = 0, m_most = 0;
    const float* m_cluster = nullptr; ///< of the nearest disc
    DiscHit m_hit;
    std::size_t m_count = 0;
    Entry m_stack[16 * surfel::laneCount]; ///< a walk leaves at most 7 entries on each level of the tree
};

void nearestDispatched(const tree::Node& root, std::span<const base::Rayf> rays, float tMin, float tMax,
                       std::size_t flight, DiscHit* out) {
    Walk walks[mostWalks];
    std::size_t which[mostWalks], next = 0, active = 0;
    const auto start = [&](std::size_t slot) {
        walks[slot].start(root, rays[next], tMin, tMax);
        which[slot] = next++;
    };
    while (active < std::min(flight, mostWalks) && next < rays.size())
        start(active++);
    while (active > 0)
        for (std::size_t i = 0; i < active;) {
            if (walks[i].step()) {
                ++i;
                continue;
            }
            out[which[i]] = walks[i].finish();
            if (next < rays.size()) {
                start(i++);
            } else if (i != --active) {
                walks[i] = walks[active];
                which[i] = which[active];
            }
        }
}

bool chordDispatched(const float* cluster, const base::Rayf& ray, float& begin, float& end) {
    const D d;
    const int width = static_cast<int>(hn::Lanes(d));
    begin = DiscHit::none, end = -DiscHit::none;
    for (int first = 0; first < lanes; first += width) {
        const Seen seen = see(d, cluster + first, ray);
        const V half = halfChord(d, seen, hn::Mul(seen.h, hn::Set(d, surfel::surfaceReach)));
        const M met = hn::Gt(half, hn::Zero(d));
        if (hn::AllFalse(d, met))
            continue;
        const V enter = hn::IfThenElse(met, hn::Sub(seen.along, half), hn::Set(d, DiscHit::none));
        const V leave = hn::IfThenElse(met, hn::Add(seen.along, half), hn::Set(d, -DiscHit::none));
        begin = std::min(begin, hn::GetLane(hn::MinOfLanes(d, enter)));
        end = std::max(end, hn::GetLane(hn::MaxOfLanes(d, leave)));
    }
    return begin < end;
}

} // namespace HWY_NAMESPACE
} // namespace surface
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace surface {

HWY_EXPORT(nearestDispatched);
HWY_EXPORT(chordDispatched);

void nearestDiscs(const tree::SurfelTree& tree, std::span<const base::Rayf> rays, float tMin, float tMax, Flight flight,
                  std::span<DiscHit> out) {
    assert(rays.size() == out.size());
    std::fill(out.begin(), out.end(), DiscHit{});
    if (tree.empty())
        return;
    const std::size_t atOnce = flight == Flight::One ? 1 : mostWalks;
    HWY_DYNAMIC_DISPATCH(nearestDispatched)(*tree.root(), rays, tMin, tMax, atOnce, out.data());
}

std::optional<std::pair<float, float>> reachChord(const float* cluster, const base::Rayf& ray) {
    float begin, end;
    if (!HWY_DYNAMIC_DISPATCH(chordDispatched)(cluster, ray, begin, end))
        return std::nullopt;
    return std::pair(begin, end);
}

} // namespace surface
#endif
