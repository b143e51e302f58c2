// Restricted Delaunay triangulation of the surface (alg. 4.5): few triangles of good shape, within a distance.
//
// After Boissonnat & Oudot, Provably good sampling and meshing of surfaces (2005), what it is:
//
//     a triangle of points on the surface belongs to the mesh where the ball through its corners about a place of the
//     surface is empty; triangles that are too thin, too large or too far away are refined by inserting that place
//
// and after Chew, Guaranteed-quality mesh generation for curved surfaces (1993), how it is found: along the surface, by
// flips, from a mesh that has the right topology. What is near in space only, such as sheets that touch and thin parts,
// needs no finer triangles therefore, and open and one-sided surfaces are meshed like others. Where the definition
// itself ends, as at folds, so does the mesh.
//
//     marching_cubes.h     the mesh to begin with          triangle_net.h       what flips and splits work on
//     coarsen_net.h        few of its vertices             surface_net.h        the same on a surface
//     delaunay_refine.h    flips, refinement               delaunay_finish.h    vertices to the surface, rims
//
// Rims are those of marching cubes; their sides are halved where others come too near (Ruppert 1995). One thread does
// most of it. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct DelaunayOptions {
    double angle = 25;       ///< least angle of triangles, in degrees; 30 at most, beyond which it may not end
    double size = 0;         ///< largest radius of a triangle's ball, in model units; 0: the median spacing
    double distance = 0;     ///< of triangles from the surface, in model units; 0: a tenth of the median spacing
    double adaptive = 0;     ///< sizes by curvature, for triangles this close to the surface; 0: one size
    bool closeFolds = false; ///< close rims where the definition ends, up to `longestFold` edges, whatever comes of
                             ///< angles and distances there
    std::size_t longestFold = 24;
    bool dropSmall = false; ///< leave out pieces of fewer than `smallPiece` triangles
    std::size_t smallPiece = 200;
};

struct DelaunayReport {
    /// Triangles left out because they broke a criterion when they were as small as is sensible: at folds and where
    /// near sheets meet, f jumps, and the mesh ends.
    std::size_t unrefined = 0;
    std::size_t removed = 0;     ///< triangles taken away to leave a manifold mesh
    std::size_t trimmed = 0;     ///< triangles at folds taken away because they cut others
    std::size_t foldsClosed = 0; ///< loops
};

/// Throws base::Cancelled, base::Error where the surface has no points or the triangles would be too many.
Mesh restrictedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                        const base::Progress& progress = {});

} // namespace mesh
