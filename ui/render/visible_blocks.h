// Which blocks of a version a camera can see: a walk of the tree that skips what lies outside the view.
//
// The place for level of detail: a node that is small in the image can answer with fewer surfels than its blocks have.
#pragma once

#include "core/tree/surfel_tree.h"
#include "ui/render/tile_mask.h"

namespace render {

struct VisibleBlock {
    const surfel::SurfelBlock* block = nullptr;
    ScreenBounds bounds;
};

/// Blocks with splats in the image, in tree order; with `only`, those that touch its tiles. `reachOfSupport`: a splat's
/// radius as a part of its support. The tree must outlive the result.
void visibleBlocks(const tree::SurfelTree& model, const ViewFrame& view, float reachOfSupport,
                   std::vector<VisibleBlock>& out, const TileMask* only = nullptr);

/// Adds the tiles that can look different in two versions: those touched by blocks that they do not share at the same
/// place of the tree. Cost: what differs.
void addChangedTiles(const tree::SurfelTree& from, const tree::SurfelTree& to, const ViewFrame& view,
                     float reachOfSupport, TileMask& out);

} // namespace render
