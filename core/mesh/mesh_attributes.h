// What the vertices of a mesh take over from the surfels around them: colours, masks and further attributes, averaged
// with the weights of the surface (alg. 2.1) over those that face the same way. Attributes that are whole numbers, such
// as labels, are those of the surfel that weighs most.
#pragma once

#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// Fills the mesh's colours, masks and further attributes where the model has them, empties them where not. In
/// parallel, the same bits at any thread count.
void takeAttributes(Mesh& mesh, const surface::Surface& surface);

} // namespace mesh
