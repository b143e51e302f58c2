// Which sharp edges of a mesh are edges of what it shows (mesh/README 8.5): those that hang together in chains. Statues
// of few triangles, and noise, have edges as sharp here and there among bumps, in chains that end soon.
#pragma once

#include "core/mesh/faces/face_topology.h"

namespace mesh {

/// Sharp edges that are to be creases, and the patches between them.
struct CreaseChains {
    std::vector<SharpEdge> edges;
    std::vector<std::uint32_t> patches; ///< of each triangle; those on both sides of an edge that is left out are one
    std::size_t patchCount = 0;
    std::vector<SharpEdge> rounded; ///< edges that are left out
    double sure = 0;                ///< length of the chains of many edges, with hardly an end, between smooth patches
};

/// All of them.
CreaseChains allChains(const FaceTopology& topology);

/// Those that are no noise, for samples about that far apart: `spacings` of each piece, or one for all.
CreaseChains clearChains(const FaceTopology& topology, std::span<const double> spacings);
inline CreaseChains clearChains(const FaceTopology& topology, double spacing) {
    return clearChains(topology, std::span(&spacing, 1));
}

} // namespace mesh
