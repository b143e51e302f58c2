// The loop of tools that move along one direction: every surfel under the brush is carried along it by an amount that
// varies.
//
//     p' = p + (1 - mask) a(p) d                       d the dab's direction, a(p) the tool's amount times the factors
//     n' ~ cof(F) n = (1 + g.d) n - (d.n) g            F = I + d g^T,  g = (1 - mask) grad a - a grad mask
//     h' = h sqrt(|cof(F) n|)                          where footprints follow: |cof(F) n| is the stretch of area
//
// The Jacobian of such a displacement has rank one, so that its cofactor matrix, which maps normals, needs no matrix.
// Normals are carried, never estimated anew: relief finer than the brush survives.
//
// A tool gives a Field: a callable (const BrushLanes&, AmountLanes&) that fills amount and gradient from the lanes'
// places; it sees neither masks nor factors nor blocks. Lanes that do not move keep their bits.
#pragma once

#include "core/sculpt/tools/brush.h"

namespace sculpt {

/// What a tool answers: how far each surfel goes along `d`, and how that varies in space.
struct AmountLanes {
    alignas(64) float amount[lanes];
    alignas(64) float gx[lanes], gy[lanes], gz[lanes];
};

/// Carries one cluster of a version; makes `changed` from `block` at the first lane that moves.
void carry(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int cluster, const base::Vec3f& direction,
           const AmountLanes& by, bool footprints, surfel::MutableBlockPtr& changed);

/// The whole dab of a tool that moves along one direction.
template <class Field>
tree::Edit displace(const tree::SurfelTree& tree, const Brush& brush, const base::Vec3f& direction,
                    const Field& field) {
    const bool free = brush.factors.none();
    return changeClusters(blocksUnder(tree, brush.centre, brush.radius), brush,
                          [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                              BrushLanes at;
                              AmountLanes by;
                              brush.place(*in.block, cluster, at);
                              field(static_cast<const BrushLanes&>(at), by);
                              if (!free)
                                  brush.factors.multiply(in.number, *in.block, cluster, by.amount, by.gx, by.gy, by.gz);
                              carry(tree, *in.block, cluster, direction, by, brush.footprints, changed);
                          });
}

} // namespace sculpt
