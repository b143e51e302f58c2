// Support radii of the distinct positions of a cloud, for work that has the cloud already.
#pragma once

#include "core/process/neighbours/cloud_neighbours.h"
#include "core/surface/definition.h"

namespace process {

/// One reach per position, > 0 and finite. `points` are the list that the cloud was made of: where its normals are
/// oriented, neighbours on the other side of a wall do not count. `near` may be empty where the definition has one
/// radius for all. REQUIRES: a cloud of at least one position.
std::vector<float> supportsOf(const Cloud& cloud, const surfel::SurfelList& points,
                              const surface::SurfaceDefinition& definition, CloudNeighbours near,
                              const base::Progress& progress = {});

} // namespace process
