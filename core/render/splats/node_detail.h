// What stands for a node of the tree where it is small in the image ([Rusinkiewicz00], render/README 4): at most a
// block of representatives, well spread over the node's surfels, and the cone of its normals.
//
// A representative is the mean of the surfels nearest to it (position, normal, colour and mask, weighted by area); its
// disc covers all of their discs, so that a picture without holes stays one. Each child of the node gives its share by
// area, chosen farthest-point first in position and normal: sheets that turn apart are not averaged. About one
// representative for seven surfels per level. Representatives of level 1 come from blocks, others from the children's.
#pragma once

#include "core/render/shading/block_colours.h"

namespace render {

/// Directions within an angle of an axis.
struct NormalCone {
    base::Vec3f axis;
    float angleRad = 4; ///< beyond pi: all directions
    bool all() const { return angleRad >= 3.1415926f; }
};

/// The narrowest cone about the mean direction; all directions where a normal is unknown.
NormalCone coneOf(const surfel::SurfelBlock& block);
/// Holds all of the cones.
NormalCone coneOf(std::span<const NormalCone> cones);

struct NodeDetail {
    surfel::BlockPtr proxy; ///< no further attributes; supports / radiusOfSupport widened
    float radius = 0;       ///< of its discs, root mean square, in model units
    NormalCone cone;
};

/// Up to 128 representatives. `parts`: the children's blocks or proxies, 1 to 8. `radiusOfSupport`: a disc's radius as
/// a part of its support. Unoriented normals may have either sign. Colours are those of the table where it has any.
surfel::BlockPtr representatives(std::span<const surfel::SurfelBlock* const> parts, float radiusOfSupport,
                                 bool oriented, const BlockColours* colours = nullptr);

} // namespace render
