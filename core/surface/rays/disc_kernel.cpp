// The walk to the nearest disc, compiled once per instruction set and chosen at run time (Google Highway).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/surface/rays/disc_kernel.cpp"
#include "core/surface/rays/disc_kernel.h"
#include "core/base/instruction_sets.h"

#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// After the main header.
#include "core/surface/rays/disc_beam.h"

#include <cassert>

HWY_BEFORE_NAMESPACE();
namespace surface {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One ray's walk, front to back, in steps so that several can be under way: each ends by asking for the memory of the
/// next.
class DiscWalk {
  public:
    void start(const tree::Node& root, const base::Rayf& ray, const DiscRange& range, bool wide = false) {
        m_search.start(ray, range, wide);
        m_slabs = Slabs(ray);
        m_stack[0] = {range.tMin, root.level, &root};
        m_count = 1;
    }

    /// Opens the nearest of what is left; false when nothing is.
    bool step() {
        while (m_count > 0) {
            const Entry next = m_stack[--m_count];
            if (next.enter > m_search.most())
                continue;
            if (next.kind > isBlock)
                openNode(*static_cast<const tree::Node*>(next.what));
            else if (next.kind == isBlock)
                openBlock(*static_cast<const surfel::SurfelBlock*>(next.what));
            else
                m_search.open(static_cast<const float*>(next.what));
            if (m_count > 0)
                prefetch(m_stack[m_count - 1]);
            return true;
        }
        return false;
    }
    bool complete() const { return m_search.complete(); }
    DiscHit finish() { return m_search.finish(); }

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
    void push(const surfel::BoundsLanes& bounds, unsigned used, int kind, const Child& child) {
        HWY_ALIGN float enter[surfel::laneCount];
        unsigned mask =
            meeting<surfel::laneCount>(BoundsArrays(bounds), m_slabs, m_search.least(), m_search.most(), enter);
        const std::size_t bottom = m_count;
        assert(m_count + surfel::laneCount <= std::size(m_stack));
        for (mask &= used; mask != 0; mask &= mask - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(mask));
            std::size_t at = m_count++;
            for (; at > bottom && m_stack[at - 1].enter < enter[i]; --at)
                m_stack[at] = m_stack[at - 1];
            m_stack[at] = {enter[i], kind, child(i)};
        }
    }
    void openNode(const tree::Node& node) {
        if (node.level == 1)
            push(node, node.childMask(), isBlock, [&](std::size_t i) -> const void* { return node.blocks[i].get(); });
        else
            push(node, node.childMask(), node.level - 1,
                 [&](std::size_t i) -> const void* { return node.nodes[i].get(); });
    }
    void openBlock(const surfel::SurfelBlock& block) {
        push(block.boundsLanes(), block.clusterMask(), isCluster,
             [&](std::size_t i) -> const void* { return block.channel(static_cast<int>(i), surfel::X); });
    }

    DiscSearch m_search;
    Slabs m_slabs;
    std::size_t m_count = 0;
    Entry m_stack[16 * surfel::laneCount]; ///< a walk leaves at most 7 entries on each level of the tree
};

static void walkTogether(const tree::Node& root, std::span<const base::Rayf> rays, const DiscRange& range,
                         DiscHit* out) {
    constexpr std::size_t most = 8;
    DiscWalk walks[most];
    std::size_t which[most], next = 0, active = 0;
    const auto start = [&](std::size_t slot) {
        walks[slot].start(root, rays[next], range);
        which[slot] = next++;
    };
    while (active < most && next < rays.size())
        start(active++);
    while (active > 0)
        for (std::size_t i = 0; i < active;) {
            if (walks[i].step()) {
                ++i;
                continue;
            }
            if (!walks[i].complete()) {
                walks[i].start(root, rays[which[i]], range, true);
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

static void walkWidely(const tree::Node& root, const base::Rayf& ray, const DiscRange& range, DiscHit& out) {
    DiscWalk walk;
    walk.start(root, ray, range, true);
    while (walk.step()) {
    }
    out = walk.finish();
}

void nearestDispatched(const tree::Node& root, std::span<const base::Rayf> rays, const DiscRange& range, DiscHit* out) {
    constexpr std::size_t fewest = 4; // rays that share a beam with profit
    DiscBeam beam;
    std::size_t done = 0;
    while (rays.size() - done >= fewest) {
        const auto run = rays.subspan(done, std::min(DiscBeam::most, rays.size() - done));
        if (!DiscBeam::alike(run))
            break;
        for (unsigned again = beam.run(root, run, range, out + done); again != 0; again &= again - 1)
            walkWidely(root, rays[done + static_cast<std::size_t>(std::countr_zero(again))], range,
                       out[done + static_cast<std::size_t>(std::countr_zero(again))]);
        done += run.size();
    }
    walkTogether(root, rays.subspan(done), range, out + done);
}

bool chordDispatched(const float* cluster, const base::Rayf& ray, float& begin, float& end) {
    const D d;
    const int width = static_cast<int>(hn::Lanes(d));
    begin = DiscHit::none, end = -DiscHit::none;
    for (int first = 0; first < lanes; first += width) {
        const Discs discs = Discs::load(d, cluster, first);
        const Seen seen = see(d, discs, ray);
        const V half = halfChord(d, seen, hn::Mul(discs.h, hn::Set(d, surfel::surfaceReach)));
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

void nearestDiscs(const tree::SurfelTree& tree, std::span<const base::Rayf> rays, const DiscRange& range,
                  std::span<DiscHit> out) {
    assert(rays.size() == out.size());
    std::fill(out.begin(), out.end(), DiscHit{});
    if (!tree.empty())
        HWY_DYNAMIC_DISPATCH(nearestDispatched)(*tree.root(), rays, range, out.data());
}

std::optional<std::pair<float, float>> reachChord(const float* cluster, const base::Rayf& ray) {
    float begin, end;
    if (!HWY_DYNAMIC_DISPATCH(chordDispatched)(cluster, ray, begin, end))
        return std::nullopt;
    return std::pair(begin, end);
}

} // namespace surface
#endif
