// The loop of tools that move every surfel its own way.
//
//     p' = p + D(p)        n' ~ cof(F) n,  F = I + grad D        h' = h sqrt(|cof(F) n|) where footprints follow
//
// D is the tool's displacement times the factors and 1 - mask, its gradient that of the product (mask_slope.h). Where a
// dab would turn a normal by more than 90 degrees (matter folded over along itself, which only a vertical rim or too
// long a step causes) the normal stays. Normals are carried, never estimated anew.
//
// A tool gives a Field: a callable (const LanePlace&, const BrushLanes&, ShiftLanes&) that fills displacements and
// gradients from the lanes' places; `LanePlace` is for those that keep something for every surfel (gather.h). Lanes
// that do not move keep their bits.
#pragma once

#include "core/base/mat3.h"
#include "core/sculpt/tools/brush.h"

namespace sculpt {

/// What a tool answers: D and its gradient, j[a][b] = dD_a / dp_b.
struct ShiftLanes {
    alignas(64) float d[3][lanes];
    alignas(64) float j[3][3][lanes];

    void set(std::size_t lane, const base::Vec3f& shift, const base::Mat3f& gradient);
    void clear();
};

struct LanePlace {
    const BrushBlock& in;
    std::size_t index; ///< of the block among those under the brush
    int cluster;
};

/// Multiplies D and its gradient by the factors of a cluster.
void multiply(const BrushFactors& factors, const LanePlace& where, ShiftLanes& by);
/// Carries one cluster; makes `changed` from its block at the first lane that moves.
void carry(const tree::SurfelTree& tree, const LanePlace& where, const ShiftLanes& by, bool footprints,
           surfel::MutableBlockPtr& changed);

/// The whole dab, on the blocks under the brush.
template <class Field>
tree::Edit deform(const tree::SurfelTree& tree, const std::vector<BrushBlock>& blocks, const Brush& brush,
                  const Field& field) {
    return changeClusters(blocks, brush,
                          [&](const BrushBlock& in, std::size_t index, int cluster, surfel::MutableBlockPtr& changed) {
                              const LanePlace where{in, index, cluster};
                              BrushLanes at;
                              ShiftLanes by;
                              brush.place(*in.block, cluster, at);
                              field(where, static_cast<const BrushLanes&>(at), by);
                              if (!brush.factors.none())
                                  multiply(brush.factors, where, by);
                              carry(tree, where, by, brush.footprints, changed);
                          });
}
template <class Field>
tree::Edit deform(const tree::SurfelTree& tree, const Brush& brush, const Field& field) {
    return deform(tree, blocksUnder(tree, brush.centre, brush.radius), brush, field);
}

} // namespace sculpt
