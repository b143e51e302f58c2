// Triangles of a whole complex (mesh/README 11): its patches, sewn together along its curves.
//
//     patch_mesh.h      one patch, cut off at its boundary
//     rim_chains.h      the vertices that all patches of a curve share
//
// Every curve is a chain of edges that all its patches have, every point a vertex; where only one patch has a curve,
// the mesh ends there. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/complexes/complex.h"
#include "core/mesh/mesh.h"

namespace mesh {

struct ComplexMeshOptions {
    double cell = 0; ///< of marching cubes; 0: the median spacing of each patch
};

/// Throws base::Error where a patch has no points of its own, base::Cancelled.
Mesh meshOfComplex(const complexes::Complex& complex, const ComplexMeshOptions& options,
                   const base::Progress& progress = {});

} // namespace mesh
