// Meshes of models with cells keep their creases (mesh/README 10): what marching cubes made of the smooth surface is
// brought onto the faces of cells and cut along the seams between them.
//
//     crease_vertices.h    which cell a vertex lies on, where an edge crosses a seam
//     crease_cut.h         vertices onto seams and corners, triangles split along them
//     crease_tidy.h        flips and collapses
//
// Only splits, flips and collapses that keep the topology: what was manifold and closed stays so. Triangles away from
// creases stay as they are, to the bit. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

/// False, and nothing changed, for models without cells, and where after five rounds the mesh still cuts itself because
/// of its creases. Attributes are taken anew. REQUIRES: normals; edges
/// of one or two triangles, one umbrella at every vertex. Throws base::Cancelled.
bool keepCreases(Mesh& mesh, const surface::Surface& surface, const base::Progress& progress = {});

} // namespace mesh
