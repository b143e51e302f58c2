// Area and volume of the surface itself (mesh/README 9): of a fine mesh of it whose vertices lie on it, and of the
// same mesh with every edge halved and the middles put on it, extrapolated to no size of triangles at all. Creases of
// models with cells are sharp.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

#include <optional>

namespace mesh {

struct Extent {
    double area = 0;
    /// What this may be wrong by: what extrapolation added, what the mesh lacks at creases (edge_shortfall.h), and what
    /// float coordinates round.
    double areaError = 0;
    bool closed = false; ///< no boundary, and two sides: it has a volume
    double volume = 0;   ///< > 0; parts whose normals point inwards, as those of caves, count against the others
    double volumeError = 0;
    std::size_t triangles = 0;     ///< of the finer mesh
    std::size_t flat = 0;          ///< middles for which there was no place on the surface: their edges stay straight
    std::size_t boundaryEdges = 0; ///< of the coarser mesh
    std::size_t foldLoops = 0;     ///< loops where the definition ends, as where sheets meet: gaps, not boundaries
    bool orientable = true;
};

/// `cell`: size of the coarser mesh's triangles; 0: the median spacing, of each part that stands apart
/// (surface_parts.h), whose sums these are then. Throws base::Error where there is no surface to
/// mesh, base::Cancelled. The same bits at any thread count.
Extent extentOf(const surface::Surface& surface, double cell = 0, const base::Progress& progress = {});

/// Of a mesh as it is. Volume by the divergence theorem about the middle of the box, > 0 where triangles face outwards.
double areaOf(const Mesh& mesh);
double volumeOf(const Mesh& mesh);

} // namespace mesh
