// Vertices of a mesh put onto the surface, and moved along it until triangles are well shaped.
//
// Every vertex moves towards the middle of its neighbours, along the surface, and is projected onto it (Newton along
// the gradient), or where near sheets meet onto its own sheet (own_sheet.h). Rims move along themselves: those by the
// limit stay rim points (alg. 6). No triangle changes its corners, so what the mesh is connected like stays. A vertex
// stays where a move would leave the surface, or turn a triangle over that was not.
//
// The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct RelaxOptions {
    int passes = 2;     ///< 0: vertices are only put onto the surface
    double share = 0.7; ///< of the way to the middle, per pass
    double cell = 0;    ///< no vertex moves by more than half of it at once
    /// Only these move and what is up to four edges from them; empty: all.
    std::vector<std::uint32_t> about;
};

/// REQUIRES: normals and kinds. Normals become the unit gradients at the vertices, with the sign they had.
void relax(Mesh& mesh, const surface::Surface& surface, const RelaxOptions& options,
           const base::Progress& progress = {});

} // namespace mesh
