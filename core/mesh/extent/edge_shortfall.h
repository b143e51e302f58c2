// How much a mesh lacks at the creases of a model (mesh/README 9): at acute edges and tips narrower than its triangles
// it ends before the edge, which no refinement of the same triangles tells of.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct Shortfall {
    double area = 0, volume = 0; ///< without sign
};

/// `cell`: size of the mesh's triangles. Nothing without cells. Throws base::Cancelled. The same bits at any thread
/// count.
Shortfall shortfallAtEdges(const surface::Surface& surface, const Mesh& mesh, double cell,
                           const base::Progress& progress = {});

} // namespace mesh
