// Restricted Delaunay triangulation of the surface (alg. 4.5), after Boissonnat & Oudot, Provably good sampling and
// meshing of surfaces (2005), by CGAL's surface mesher:
//
//     a facet of the Delaunay triangulation of points on the surface belongs to the mesh where its dual edge meets the
//     surface; the ball about that place through the facet's corners is empty. Facets that are too thin, too large or
//     too far away are refined by inserting the ball's centre.
//
// All that is asked of the surface is where a segment meets it (surface/segments.h), so that open and one-sided
// surfaces are meshed like closed ones: CGAL's volume mesher, the other choice, wants to know inside from outside.
// Traced rims (surface/rims.h) are vertices from the beginning and are split where others come too near (Ruppert
// 1995), so that the mesh ends in smooth polylines.
//
//     delaunay_start.h   points to begin with: rims, and surfels spread over every piece
//     restricted.h       the triangulation; the only header in front of CGAL's mesher
//     delaunay_finish.h  vertices to the surface, sides, attributes
//
// One thread does most of it. The same bits at any thread count.
#pragma once

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/surface/surface.h"

namespace mesh {

struct DelaunayOptions {
    double angle = 25;      ///< least angle of triangles, in degrees; 30 at most, beyond which it may not end
    double size = 0;        ///< largest radius of a triangle's ball, in model units; 0: the median spacing
    double distance = 0;    ///< of triangles from the surface, in model units; 0: a tenth of the median spacing
    double adaptive = 0;    ///< sizes by curvature, for triangles this close to the surface; 0: one size
    bool snapToRims = true; ///< trace rims and let the mesh end there; false: it ends up to `size` before them
};

struct DelaunayReport {
    std::size_t rims = 0;      ///< traced, vertices of the mesh along them
    std::size_t rounds = 0;    ///< how often pieces were found uncovered and begun anew, with the first
    std::size_t uncovered = 0; ///< surfels that no triangle is near to, although the surface is there
    /// Triangles left out because they broke a criterion when they were as small as is sensible: at folds and where
    /// near sheets meet, f jumps, and the mesh ends.
    std::size_t unrefined = 0;
    std::size_t removed = 0; ///< triangles taken away to leave a manifold mesh
};

/// Throws base::Cancelled, base::Error where the surface has no points.
Mesh restrictedDelaunay(const surface::Surface& surface, const DelaunayOptions& options, DelaunayReport& report,
                        const base::Progress& progress = {});

} // namespace mesh
