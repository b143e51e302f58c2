// What lies under the brush: the surfels' places in it, 16 at a time, and what the falloff, the factors that all tools
// share (brush_factors.h) and the mask leave of a dab there.
//
// Tools work by clusters of 16 lanes, blocks in parallel and returned in tree order, so that threads do not show.
#pragma once

#include "core/sculpt/brush_factors.h"

#include <functional>

namespace sculpt {

constexpr std::size_t lanes = surfel::clusterSize;

/// Where 16 surfels lie in the brush.
struct BrushLanes {
    alignas(64) float x[lanes], y[lanes], z[lanes]; ///< p - centre
    alignas(64) float r[lanes];                     ///< its length in radii
};

/// A block with a cluster box in the ball.
struct BrushBlock {
    std::uint32_t number;
    const surfel::SurfelBlock* block;
};

/// The ball that a dab works in and what fades it.
struct Brush {
    base::Vec3f centre;
    float radius = 0;
    Falloff falloff = Falloff::Smooth;
    float plateau = 0; ///< part of the radius in which the weight is that of the centre
    std::shared_ptr<const BrushCurve> curve;
    BrushFactors factors;
    bool footprints; ///< supports follow the stretch

    explicit Brush(const Dab& dab)
        : centre(dab.centre), radius(dab.radius), falloff(dab.falloff), curve(dab.curve), factors(dab),
          footprints(dab.footprints) {}
    bool reaches(const surfel::SurfelBlock& block, int cluster) const {
        return block.bounds(cluster).box.distanceSq(centre) < radius * radius;
    }
    /// Places of a cluster's slots.
    void place(const surfel::SurfelBlock& block, int cluster, BrushLanes& out) const;
    /// The falloff's weight w(r), and the factor k of its gradient grad w = k (p - centre).
    void fade(const BrushLanes& at, float* weight, float* gradient) const;
    /// The finished weights of a cluster for tools that move nothing: falloff, factors and, unless it is the mask
    /// itself that changes, mask. 0 in slots beyond the block's size. Returns whether any is not 0.
    bool weigh(const BrushBlock& in, int cluster, float* weight, bool protect = true) const;
};

/// In tree order.
std::vector<BrushBlock> blocksUnder(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius);

/// The edit that puts the changed blocks (null: unchanged) in place of those under the brush.
tree::Edit editOf(const std::vector<BrushBlock>& blocks, std::vector<surfel::BlockPtr> changed);

/// Calls make(block, index) for every block under the brush, in parallel, and gathers the changed ones (null:
/// unchanged).
tree::Edit changeBlocks(const std::vector<BrushBlock>& blocks,
                        const std::function<surfel::BlockPtr(const BrushBlock&, std::size_t index)>& make);

/// Runs `work(block, index, cluster, changed)` on all clusters under the brush; it clones `changed` from the block
/// where it has something to write.
template <class Work>
tree::Edit changeClusters(const std::vector<BrushBlock>& blocks, const Brush& brush, const Work& work) {
    return changeBlocks(blocks, [&](const BrushBlock& in, std::size_t index) -> surfel::BlockPtr {
        surfel::MutableBlockPtr changed;
        for (int cluster = 0; cluster < in.block->clusterCount(); ++cluster)
            if (brush.reaches(*in.block, cluster))
                work(in, index, cluster, changed);
        if (changed)
            changed->seal();
        return changed;
    });
}

} // namespace sculpt
