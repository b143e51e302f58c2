// Cuts the triangles of a mesh along the creases of its surface (mesh/README 10.2): every seam becomes a chain of
// edges, every corner a vertex. Internal to the room.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/finish/untangle.h"
#include "core/mesh/seams/crease_memory.h"

namespace mesh {

/// A mesh and what its parts belong to.
struct CutMesh {
    Mesh mesh;
    std::vector<CreaseVertex> vertices; ///< as the mesh's
    std::vector<base::Vec3d> facing;    ///< of each triangle: the normal of its cell there
    std::vector<std::uint32_t> cells;   ///< of each triangle
    VertexPlaces before;                ///< on the triangles that were there before
    /// Of vertices that were not there before, from the first one on: those that they are between, repeated or not.
    std::vector<std::array<std::uint32_t, 3>> between;
};

/// Vertices near seams and corners move there; edges whose ends lie on different sides of a seam are split on it, and
/// triangles with them. `onFaces`: the mesh's vertices by ontoFaces; those without cells stay as they are, and no
/// crease passes between them and others. `memory`: of earlier cuts, which changes nothing but the time. REQUIRES:
/// edges of one or two triangles, one umbrella at every vertex. In parallel, the same bits at any thread count.
CutMesh cutAtCreases(const cells::CellSurface& surface, Mesh mesh, std::vector<CreaseVertex> onFaces,
                     CreaseMemory& memory, const base::Progress& progress);

} // namespace mesh
