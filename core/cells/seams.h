// Seams and corners of a model with cells as curves (cells/README 9): what is counted, measured and drawn of them.
#pragma once

#include "core/base/progress.h"
#include "core/cells/cell_surface.h"

namespace cells {

/// A curve along which two cells meet, from one corner or end to the next.
struct Seam {
    std::uint32_t a = 0, b = 0;
    std::vector<base::Vec3d> points; ///< half a spacing apart at most; of a closed one the first is the last as well
    bool closed = false;
    double spacing = 0; ///< at its beginning

    double length() const;
};

/// By pairs of cells, then as they are found. In parallel by pairs, the same at any thread count. Throws
/// base::Cancelled.
std::vector<Seam> traceSeams(const CellSurface& surface, const base::Progress& progress = {});

/// Places where three or more seams end, one for each.
std::vector<base::Vec3d> cornersOf(std::span<const Seam> seams);

} // namespace cells
