// What the vertices of a mesh take over from the surfels around them: colours and masks, averaged with the weights of
// the surface (alg. 2.1) over those that face the same way.
#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Fills the mesh's colours and masks where the model has them, empties them where not. In parallel, the same bits at
/// any thread count.
void takeAttributes(Mesh& mesh, const surface::Surface& surface);

} // namespace mesh
