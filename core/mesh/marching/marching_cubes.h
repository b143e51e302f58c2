// Marching cubes for surfaces with a frame that has a direction, or no direction at all (mesh/README 3).
//
// After [Adamson07, 4.4]. The unit of decision is a crossing per edge of the grid, a connection per face, a loop per
// cube: there are no signs at corners and no tables, so nothing that the cubes about an edge or face could disagree
// upon. Every edge of the mesh has one or two triangles, every vertex one umbrella of them, whatever the surface, its
// frame and the cell size.
//
//     surface_grid.h    cubes near the surface, crossings      edge_walk.h         one edge
//     grid_face.h       pairs of crossings in a face           boundary_trace.h    where the surface ends in a face
//     cube_loops.h      loops around a cube                    cube_filler.h       their triangles (fill_loop.h)
//     cube_tree.h       cubes that are joined where flat       relax_mesh.h        well-shaped triangles
//     hold_tolerance.h  triangles that are too far away        cut_mesh.h          all of that up to triangles
//     graded_grid.h     cubes as surfels are apart             cube_levels.h       how far halved where (cube_sizes.h)
//
// and from core/mesh/finish
//
//     orient_mesh.h     which way triangles face               close_folds.h       loops at folds closed
//     trim_folds.h      what cuts itself beside the boundary   own_sheet.h         one of two near sheets
//
// Where the surface ends, the mesh ends in a polyline: at its off-centre limit on the surface's boundary curve
// (surface/README 5.3), or where the definition ends: folds, thin parts. The report counts the two separately.
//
// The same bits at any thread count. Memory follows the number of cubes that the surface passes through.
#pragma once

#include "core/base/mat3.h"
#include "core/base/progress.h"
#include "core/mesh/finish/finishing.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct MarchingOptions {
    /// Side of a cube in model units; 0: the median spacing, of each part that stands apart (surface_parts.h), or as
    /// large as surfels are apart where that varies (mesh/README 3.16), and as walls are thin (3.17).
    double cell = 0;
    /// Rows: directions of the grid's axes. A rotation.
    base::Mat3d turned = base::Mat3d::identity();
    base::Vec3d shift; ///< of the grid, in cells
    /// In model units: where the middles of their triangles stay so close to the surface, cubes become up to 16 times
    /// as large; `cell` is then the smallest, whose triangles are as far away as they are. 0: all of one size.
    double adaptive = 0;
    /// Closed oriented surfaces bound a solid, and so the mesh has no boundary (mesh/README 3.14). False: they are
    /// meshed as open ones are.
    bool solid = true;
    bool relax = true; ///< shape triangles; otherwise vertices stay on the grid's edges
    /// Of models with cells seams are chains of edges (seams/keep_creases.h).
    bool creases = true;
    Finishing finishing;
};

struct MarchingReport {
    double cell = 0;             ///< that was used
    std::size_t cubes = 0;       ///< that the surface passes through, of all sizes
    double largestCell = 0;      ///< that was used
    std::size_t limitEnds = 0;   ///< vertices of the boundary by the limit
    std::size_t foldEnds = 0;    ///< those where the definition ends
    std::size_t foldsClosed = 0; ///< loops
    std::size_t trimmed = 0;     ///< triangles left out beside the boundary, because they cut others
    std::size_t pieces = 0;      ///< connected, before any were dropped
    std::size_t smallPieces = 0; ///< fewer triangles than `smallPiece`
    /// Edges whose two triangles run the same way along it: none where the mesh has two sides.
    std::size_t parityConflicts = 0;
    bool orientable() const { return parityConflicts == 0; }
};

/// Throws base::Error where there is no surface to mesh (curves; no surfels; nothing found) or the cells are too small
/// for the model, base::Cancelled.
Mesh marchingCubes(const surface::Surface& surface, const MarchingOptions& options, MarchingReport& report,
                   const base::Progress& progress = {});

} // namespace mesh
