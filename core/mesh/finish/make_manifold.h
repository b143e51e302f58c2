// Makes any set of triangles manifold by removing as few and as small ones as it can.
#pragma once

#include "core/mesh/mesh.h"

namespace mesh {

/// Removes triangles, the smallest first, until no edge has more than two, and splits vertices with several umbrellas.
/// Returns how many triangles it removed. REQUIRES: kinds.
std::size_t makeManifold(Mesh& mesh);

} // namespace mesh
