// Walks along the boundary of a triangulation (mesh/README 2.2): the only place where boundary loops are followed.
//
// From a side on the boundary a walk turns about its end, within the umbrella there, to the next one. So where a vertex
// is pinched, loops are those that cutting the umbrellas apart would leave.
#pragma once

#include "core/mesh/connectivity/triangulation.h"

namespace mesh {

/// Sides in the order of the walk; each runs as its own face does. Not closed where the walk meets an edge of more than
/// two faces.
using BoundaryLoop = std::vector<Side>;

/// In the order of their first sides, as forSides has them; each starts with that side, towards its end.
std::vector<BoundaryLoop> boundaryLoops(const Triangulation& triangulation);

/// By vertex: is it at the end of a side on the boundary?
std::vector<bool> boundaryVertices(const Triangulation& triangulation);

} // namespace mesh
