// The loop that tools share: every surfel under the brush is carried along one direction by an amount that varies.
//
//     p' = p + (1 - mask) a(p) d                       d the dab's direction, a(p) the tool's amount, times what
//                                                      brush_factors.h has: front-facing, connected, stamp
//     n' ~ cof(F) n = (1 + g.d) n - (d.n) g            F = I + d g^T,  g = (1 - mask) grad a
//
// The Jacobian of such a displacement has rank one, so that its cofactor matrix, which maps normals, needs no matrix.
// Normals are carried, never estimated anew: relief finer than the brush survives.
//
// Work goes by clusters of 16 lanes. A tool gives a Field: a callable (const BrushLanes&, AmountLanes&) that fills
// amount and gradient from the lanes' places; it sees neither masks nor blocks. Lanes that do not move keep their bits.
// Blocks are done in parallel and returned in tree order.
#pragma once

#include "core/sculpt/brush_factors.h"

namespace sculpt {

constexpr std::size_t lanes = surfel::clusterSize;

/// Where 16 surfels lie in the brush.
struct BrushLanes {
    alignas(64) float x[lanes], y[lanes], z[lanes]; ///< p - centre
    alignas(64) float r[lanes];                     ///< its length in radii
};

/// What a tool answers: how far each surfel goes along `d`, and how that varies in space.
struct AmountLanes {
    alignas(64) float amount[lanes];
    alignas(64) float gx[lanes], gy[lanes], gz[lanes];
};

/// The ball that a dab works in and the falloff that fades it.
struct Brush {
    base::Vec3f centre;
    float radius = 0;
    Falloff falloff = Falloff::Smooth;
    float plateau = 0;                       ///< part of the radius in which the weight is 1
    std::shared_ptr<const BrushCurve> curve; ///< of Falloff::Custom
    BrushFactors factors; ///< what multiplies weights further; `displace` does it, loops of a tool's own must

    explicit Brush(const Dab& dab)
        : centre(dab.centre), radius(dab.radius), falloff(dab.falloff), curve(dab.curve), factors(dab) {}
    /// Places of a cluster's slots.
    void place(const surfel::SurfelBlock& block, int cluster, BrushLanes& out) const;
    /// Weight w(r) and the factor k of its gradient grad w = k (p - centre).
    void fade(const BrushLanes& at, float* weight, float* gradient) const;
};

/// Blocks with a cluster box in the ball, in tree order.
struct BrushBlock {
    std::uint32_t number;
    const surfel::SurfelBlock* block;
};
std::vector<BrushBlock> blocksUnder(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius);

/// Carries one cluster; makes `changed` from `block` at the first lane that moves.
void carry(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& direction, const AmountLanes& by,
           surfel::MutableBlockPtr& changed);

/// Calls make(block) for every block under the brush, in parallel, and gathers the changed ones (null: unchanged).
tree::Edit changeBlocks(const std::vector<BrushBlock>& blocks,
                        const std::function<surfel::BlockPtr(const BrushBlock&, std::size_t index)>& make);

/// The whole dab of a tool that moves along one direction.
template <class Field>
tree::Edit displace(const tree::SurfelTree& tree, const Brush& brush, const base::Vec3f& direction,
                    const Field& field) {
    const float reachSq = brush.radius * brush.radius;
    return changeBlocks(blocksUnder(tree, brush.centre, brush.radius),
                        [&](const BrushBlock& in, std::size_t) -> surfel::BlockPtr {
                            surfel::MutableBlockPtr changed;
                            BrushLanes at;
                            AmountLanes by;
                            for (int cluster = 0; cluster < in.block->clusterCount(); ++cluster) {
                                if (in.block->bounds(cluster).box.distanceSq(brush.centre) >= reachSq)
                                    continue;
                                brush.place(*in.block, cluster, at);
                                field(static_cast<const BrushLanes&>(at), by);
                                brush.factors.multiply(in.number, *in.block, cluster, by.amount, by.gx, by.gy, by.gz);
                                carry(*in.block, cluster, direction, by, changed);
                            }
                            if (changed)
                                changed->seal();
                            return changed;
                        });
}

} // namespace sculpt
