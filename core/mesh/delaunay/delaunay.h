// Restricted Delaunay triangulation of the surface (mesh/README 4): few triangles of good shape, within a distance.
//
// What it is, after [Boissonnat05]:
//
//     a triangle of points on the surface belongs to the mesh where the ball through its corners about a point of the
//     surface is empty; triangles that are too thin, too large or too far away are refined by inserting that point
//
// and how it is found, after [Chew93]: along the surface, by flips, from a mesh that has the right topology. What is
// near in space only, such as touching sheets and thin parts, therefore needs no finer triangles, and open and
// one-sided surfaces are meshed like others. Where the definition itself ends, as at folds, so does the mesh of an open
// surface; that of a closed one has no boundary and cuts itself nowhere.
//
//     marching_cubes.h        the mesh to begin with       surface_triangulation.h    what flips and splits work on
//     coarsen.h               few of its vertices          delaunay_finish.h          vertices to the surface
//     held_faces.h            what is no surface           kept_closed.h, cut_guard.h what edits may do to a closed
//     mesh delaunay_refine.h       flips, refinement            core/mesh/finish           what both methods do at the
//     end
//
// Boundary loops are those of marching cubes; their sides are halved where others come too near [Ruppert95]. One thread
// does most of it. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/finish/finishing.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct DelaunayOptions {
    double angle = 25; ///< least angle of triangles, in degrees; at most 30, beyond which refinement may not end
    /// Largest radius of a triangle's ball, in model units; 0: the median spacing, of each part that stands apart
    /// (surface_parts.h).
    double size = 0;
    double distance = 0; ///< of triangles from the surface, in model units; 0: a tenth of the median spacing
    double adaptive = 0; ///< sizes by curvature, for triangles this close to the surface; 0: one size
    /// Of models with cells seams are chains of edges (seams/keep_creases.h); angles are promised away from them.
    bool creases = true;
    Finishing finishing;
};

struct DelaunayReport {
    /// Triangles removed because they broke a criterion and were too small to refine: f jumps at folds and where near
    /// sheets meet, and the mesh ends there.
    std::size_t unrefined = 0;
    std::size_t removed = 0;     ///< triangles removed to make the mesh manifold
    std::size_t trimmed = 0;     ///< triangles at folds removed because they cut others
    std::size_t foldsClosed = 0; ///< loops
    /// Of a closed mesh: triangles that break a criterion and stay, where points leave gaps or sheets run together.
    std::size_t missed = 0;
};

/// Throws base::Cancelled, base::Error where the surface has no points or the triangles would be too many.
Mesh restrictedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                        const base::Progress& progress = {});

} // namespace mesh
