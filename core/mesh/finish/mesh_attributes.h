// Colours, masks and further attributes of a mesh's vertices: averages over the surfels around them that face the same
// way, with the weights of the surface (mesh/README 5). Attributes that are whole numbers, such as labels, come from
// the surfel that weighs most.
#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Fills the colours, masks and further attributes that the model has and clears the others. Runs in parallel; same
/// bits at any thread count.
void takeAttributes(Mesh& mesh, const surface::Surface& surface);

} // namespace mesh
