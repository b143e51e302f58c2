// Where an edge of the grid crosses a closed surface, given that one of its ends is inside (mesh/README 3.14). Internal
// to the room.
//
// A root of f that counts, where the surface faces the right way; else where the winding number passes a half, or the
// height of solid.h zero. There is always an answer.
#pragma once

#include "core/mesh/marching/edge_walk.h"
#include "core/mesh/marching/solid.h"

namespace mesh {

struct SolidEnds {
    const NodeValue &first, &last;
    int way = 1; ///< 1 where the first is inside: the surface faces along the edge; -1 where the last is
};

Crossing solidCrossing(const Solid& solid, const SurfaceTraits& traits, surface::Source& source, const Edge& edge,
                       const SolidEnds& ends);

} // namespace mesh
