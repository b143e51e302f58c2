// A crease along a line that is drawn on the surface, and its inverse (cells/README 8).
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <span>

namespace cells {

struct DrawnCrease {
    surface::Surface surface; ///< as it was where nothing was to do
    std::size_t creased = 0;  ///< surfels beside what is a crease now and was none
    std::size_t changed = 0;  ///< surfels beside creases that were there, with another sharpness now
};

/// The line goes through the points (stored coordinates) in their order, each moved onto the surface; one that ends
/// where it began is closed. Along it the surface becomes a crease of that sharpness, 0 to 1; creases that it follows
/// become as sharp as that, and with 0 they are smooth: cells that no crease parts any more are one. Throws base::Error
/// where a point is not near the surface, and as detectCreases does; base::Cancelled.
DrawnCrease drawCrease(const surface::Surface& surface, std::span<const base::Vec3d> line, double sharpness,
                       const base::Progress& progress = {});

} // namespace cells
