// The umbrellas of a triangulation: corners of one vertex that meet across manifold edges, closed inside, open on the
// boundary (mesh/README 2.1). A vertex is manifold where it has one.
#pragma once

#include "core/mesh/connectivity/triangulation.h"

namespace mesh {

/// For corner 3 f + i of all faces f: the number of its umbrella, which is that of its first corner; none for faces
/// that are gone.
std::vector<std::uint32_t> umbrellasOf(const Triangulation& triangulation);

} // namespace mesh
