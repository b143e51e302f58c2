// Labels of surfels from the creases between their cells, where these are known as straight pieces: sharp edges of a
// mesh, edges of a solid (cells/README 1.2).
#pragma once

#include "core/cells/labels.h"

#include <span>

namespace cells {

/// A straight piece of a crease between two cells.
struct CreasePiece {
    base::Vec3d from, to;
    std::uint32_t left = 0, right = 0; ///< in any order
    Meeting meeting = Meeting::Convex;
};

/// How far a crease has surfels beside it as theirs, in spacings.
constexpr double partnerReach = 2;

/// Of each position with its cell: partner and sign by the nearest piece of a crease of that cell within partnerReach
/// spacings. Faces are the cells themselves, everything is sharp. In parallel, the same at any thread count.
std::vector<Label> labelsByCreases(std::span<const surfel::Surfel> surfels, std::span<const std::uint32_t> cells,
                                   std::span<const CreasePiece> creases, double spacing);

} // namespace cells
