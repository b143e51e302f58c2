// How a seam goes on where it passes an edge of one of the two surfaces (solid/README 2.5). Inside this room only.
#pragma once

#include "core/solid/seam.h"

namespace solid {

/// Does either surface turn by more than 20 degrees from one place to the other?
bool turnsBetween(const SeamPoint& a, const SeamPoint& b);

struct SeamTurn {
    std::optional<SeamPoint> corner; ///< on the edge; none where the seam goes straight on
    SeamPoint next;                  ///< on the seam beyond it
};

/// From a place just before an edge, `forward` along its tangent (1) or against it (-1): the surface without an edge is
/// looked at along a small circle about the place, where the other one's inside ends. Whatever the angle of the turn.
/// Nothing where the seam ends.
std::optional<SeamTurn> aroundCorner(const TwoSides& sides, const SeamPoint& at, double forward, double spacing);

} // namespace solid
