// The inner loops of the CPU splatter, vectorised, chosen at run time for the processor. One tile at a time:
//
//     gatherSplats     clusters of surfels -> splats in view coordinates that touch the tile
//     splatVisibility  pass 1: per pixel, how far behind its nearest splat others still belong to the same layer
//     splatAttributes  pass 2: sums of normals, depths, colours and masks of that layer, weighted by exp(-2 r^2)
//
// after [Botsch05]; render/README 2.
//
// A splat is a disc. Along the ray of slope d = (x, y, 1), 1/z = (n.d)/(n.p) is linear in x and y, so the exact meeting
// of ray and plane costs one division. r^2 = |z d - p|^2 / R^2, or the squared distance from the projected centre in
// units of the filter's pixel where that is less: splats never fall between pixels. Where supports are ellipsoids
// (surfel/shape.h) the disc is an ellipse: (b.(z d - p))^2 / R^2 more. With parallel rays -z takes the place of 1/z
// (view_frame.h). Fragments behind a clip plane count for neither pass.
#pragma once

#include "core/render/shading/block_colours.h"
#include "core/render/splats/tile_bins.h"
#include "core/surfel/surfel_block.h"

namespace render {

/// Usual splat radius as a part of the support radius: 1.29 spacings for supports of 38 neighbours (h = 3.48 s), which
/// closes every hole of a hexagonal layout and of a random one with the gaps of a Poisson-disc sampling.
constexpr float splatRadiusOfSupport = 0.37f;
/// Radius of the screen-space filter in pixels.
constexpr float filterPx = 1;
/// Splats within this many radii (and filter radii) behind the nearest belong to its layer.
constexpr float layerDepth = 1;
/// A splat's depths stay within its radius and this many filter radii of its centre's: a pixel of the filter beside an
/// edge-on disc meets its plane far away.
constexpr float filterDepth = 4;
/// Splats seen from behind count as if they were farther by this part of it: the far side of a thin sheet does not
/// bleed through, and the inside of an open one is blended as its outside is.
constexpr float backBias = 0.9f;
/// And the part of their disc that rises towards the eye is cut at this part of its radius: at a silhouette it would
/// stand out beyond the surface, which bends away there.
constexpr float backClip = 0.35f;
/// Of a solid with sharp edges, splats that look away by more than this (a cosine) are only seen where nothing else is:
/// of a face behind an edge a part of a pixel stands out, dark. Up to there they round the outline of what is smooth.
constexpr float solidAway = 0.2f;
/// The smallest cosine between a splat and its ray: an edge-on disc is drawn as thin as that, not infinitely.
constexpr float minCosine = 0.02f;

/// What a model's splats show.
struct SplatStyle {
    float radiusOfSupport = splatRadiusOfSupport;
    bool oriented = false; ///< otherwise splats turn to the eye
    /// Of a solid that is seen from outside: no back shows before any front, so that what looks away is as much
    /// farther. Model units, 0: others.
    float backsFarther = 0;
    bool colours = false;                ///< sum colours and masks too
    int shape = 0;                       ///< channel of the shapes of supports; 0: discs are round
    bool coloured = false;               ///< and shade with the colours: else only the masks are seen
    const BlockColours* table = nullptr; ///< its colours, where it has any, instead of the surfels' own
    bool operator==(const SplatStyle&) const = default;
};

/// One splat in view coordinates.
struct Splat {
    float x, y, z;         ///< image place of the centre, and its depth
    float gradX, gradY;    ///< of its plane's w (view_frame.h) across the image
    float low, high;       ///< range of w, see filterDepth
    float cut;             ///< w from where the disc is cut, see backClip
    float inverseRadiusSq; ///< 1/R^2
    float reach;           ///< what belongs to its layer may lie this far behind
    float bias;            ///< > 0 where it is seen from behind
    float normalX, normalY, normalZ;
    float mask;
    surfel::Colour colour;
    std::uint8_t left, right, top, bottom; ///< pixels of the tile, inclusive
    /// The disc ends where (x - centre) . edge = 1, in view coordinates; zero where it is whole (disc_cuts.h).
    base::Vec3f edge, secondEdge;
    base::Vec3f shape; ///< b in view coordinates, in the plane of the disc; zero where that is round
};

/// Pixels of a tile; rows are longer than the tile so that a vector may run past its end.
constexpr int tileStride = tileWidth + 8;
struct TileSums {
    float limit[tileHeight * tileStride]; ///< depth up to which splats belong to the nearest layer; 0 outside the image
    float weight[tileHeight * tileStride];
    float depth[tileHeight * tileStride];
    float normal[3][tileHeight * tileStride];
    float colour[3][tileHeight * tileStride]; ///< 0 to 255
    float mask[tileHeight * tileStride];
};

struct TileArea {
    int left = 0, top = 0, width = 0, height = 0;
};

void clearTile(const TileArea& area, bool colours, TileSums& sums);
/// Appends the visible splats of the entry; `out` has room for a block. Returns how many.
int gatherSplats(const BinEntry& entry, const ViewFrame& view, const SplatStyle& style, const TileArea& area,
                 Splat* out);
void splatVisibility(std::span<const Splat> splats, const ViewFrame& view, const TileArea& area, TileSums& sums);
/// Largest limit of the tile: splats all behind it are hidden. +inf while a pixel is empty.
float farthestLimit(const TileArea& area, const TileSums& sums);
void splatAttributes(std::span<const Splat> splats, const ViewFrame& view, const SplatStyle& style,
                     const TileArea& area, TileSums& sums);

} // namespace render
