// Puts the vertices of a mesh onto the surface and moves them along it until triangles are well shaped (mesh/README
// 3.13).
//
// Each vertex moves towards the mean of its neighbours and is projected back by Newton's method along the gradient, or
// onto its own sheet where several are near (own_sheet.h). Boundary vertices move along the boundary; those at the
// limit stay on its curve (surface/README 5.3). Connectivity does not change. A vertex stays put where a move would
// leave the surface or turn a triangle over.
//
// Same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct RelaxOptions {
    int passes = 2;     ///< 0: only project vertices onto the surface
    double share = 0.7; ///< of the way to the mean, per pass
    double cell = 0;    ///< a vertex moves by at most half of it at once
    /// Move only these and vertices up to four edges away; empty: all.
    std::vector<std::uint32_t> about;
    /// By vertex, instead of `cell` where cubes are of several sizes; else empty.
    std::vector<float> cells;
};

/// REQUIRES: normals and kinds. Normals become unit gradients and keep their sign.
void relax(Mesh& mesh, const surface::Surface& surface, const RelaxOptions& options,
           const base::Progress& progress = {});

} // namespace mesh
