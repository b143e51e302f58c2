// Which samples of faces lie beside a rim: the boundary of the faces is that of the surface (surface/rims.h).
//
// A hole so small that supports reach across it has no rim: the surface goes over it.
#pragma once

#include "core/mesh/faces/face_topology.h"
#include "core/surfel/surfel.h"

namespace mesh {

/// Gives the samples the attribute `rim`. `supports`: of each; 0: unknown, for points that lie on none of the faces.
/// Returns false, with the samples as they are, where the boundary is not that of all of them: nothing is known of
/// points without faces. REQUIRES: topology.borderEdges are not empty. Time: that of a tree of the samples.
bool markRims(const FaceTopology& topology, std::span<const float> supports, surfel::SurfelList& samples);

} // namespace mesh
