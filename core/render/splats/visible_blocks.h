// The part of a version that a camera can see: a walk of the tree that skips what lies outside the view, and lets a
// node that is small in the image answer with its representatives (node_detail.h) instead of its blocks.
//
// The choice follows from the node and the view alone, so that what two versions share looks the same in both.
#pragma once

#include "core/render/splats/detail_cache.h"
#include "core/render/splats/disc_cuts.h"
#include "core/render/splats/finer_blocks.h"
#include "core/render/tile_mask.h"

namespace render {

struct VisibleBlock {
    const surfel::SurfelBlock* block = nullptr; ///< of the tree, or a node's proxy
    ScreenBounds bounds;
    bool proxy = false;
    bool large = false;             ///< findCuts looked at it
    const CutCodes* cuts = nullptr; ///< where discs are cut; null: they are whole
};

/// How a version is looked at.
struct Sight {
    const ViewFrame& view;
    float reachOfSupport;           ///< a splat's radius as a part of its support
    DetailCache* details = nullptr; ///< null: blocks alone
    float detailPx = 0;   ///< representatives show where their discs' usual radius is at most this many pixels
    bool closed = false;  ///< leave out nodes that look away from the eye with all their normals
    float standOut = 1;   ///< what is drawn for a block reaches this many radii beyond it (finer_blocks.h)
    float pixelScale = 1; ///< pixels for one that a person sees
};

/// Blocks and proxies with splats in the image, in tree order; with `only`, those that touch its tiles. The tree and
/// the cache must outlive the result. Makes the details it needs: with all cores if there is no `only`.
void visibleBlocks(const tree::SurfelTree& model, const Sight& sight, std::vector<VisibleBlock>& out,
                   const TileMask* only = nullptr);

/// Finds where the discs of those that are large enough in the image are cut. REQUIRES: `cuts` follows the version.
void findCuts(const Sight& sight, DiscCuts& cuts, std::span<VisibleBlock> blocks);

/// Puts finer blocks in the place of those whose discs are large in the image and stand out over the surface by what
/// can be seen. Call it after findCuts. REQUIRES: `finer` follows the version.
void findFiner(const Sight& sight, FinerBlocks& finer, std::vector<VisibleBlock>& blocks);

/// Adds the tiles that can look different in two versions: those touched by blocks and proxies that they do not share
/// at the same place of the tree. Cost: what differs.
void addChangedTiles(const tree::SurfelTree& from, const tree::SurfelTree& to, const Sight& sight, TileMask& out);
/// Adds the tiles that the blocks touch.
void addTiles(std::span<const surfel::SurfelBlock* const> blocks, const Sight& sight, TileMask& out);

} // namespace render
