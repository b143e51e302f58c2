// A line on the surface through points near it, in steps of half a spacing.
#pragma once

#include "core/cells/creases/surfel_links.h"
#include "core/surface/surface.h"

namespace cells {

struct LinePiece {
    base::Vec3d from, to;
    std::uint32_t nearest = 0; ///< surfel
    base::Vec3d normal;        ///< mean of those around: at an edge between both sides'
};

struct SurfaceLine {
    std::vector<LinePiece> pieces;
    bool closed = false;
};

/// Throws base::Error where a point is farther from the surface than its supports, and where there is no way along the
/// surface from one to the next.
SurfaceLine lineOnSurface(const surface::Surface& surface, const SurfelLinks& links,
                          std::span<const base::Vec3d> points);

} // namespace cells
