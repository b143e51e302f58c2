// The recursive projection psi_C onto one cell, and where cells end [Adamson07, 9.2].
//
//     x <- c + T T^T (from - c)   with c and T of cell_frame.h at x, until x rests; where it rests on the boundary, or
//                                 past it, the boundary's own foot counts
//
// A point that two patches share is projected by both to the same bits: complexes have no seams to close.
#pragma once

#include "core/complexes/cell_frame.h"
#include "core/surface/projection/project.h"

namespace complexes {

struct CellFoot {
    surface::Status status = surface::Status::Outside;
    base::Vec3d position;
    base::Vec3d axis;     ///< of the cell that was asked: a patch's normal, a curve's tangent
    std::uint32_t on = 0; ///< the cell that it lies on: the one asked, a curve of its boundary, or an end of one
    double unit = 0;      ///< h there
    int iterations = 0;

    bool ok() const { return status == surface::Status::Ok; }
};

struct FootOptions {
    surface::Projector projector = surface::Projector::Basic; ///< Orthogonal only of patches
    bool restricted = true; ///< false: the cell as its frame carries it on past its boundary
    bool anywhere = false;  ///< positions out of reach start from the cell's nearest point
    base::Vec3d side;       ///< of patches without a side of their own
};

/// psi_C. Of points their place.
CellFoot footOn(const Complex& complex, std::uint32_t cell, const base::Vec3d& x, const FootOptions& options);

/// Past the boundary? `frame`: of the cell at x, which lies on the cell or on what its frame carries on.
bool isPast(const Complex& complex, std::uint32_t cell, const base::Vec3d& x, const CellFrame& frame);

/// grad f of a patch, f = n . (x - c), by central differences; zero where f has none. `side`: of the normal.
base::Vec3d gradientOf(const Complex& complex, std::uint32_t cell, const base::Vec3d& x, const CellFrame& frame);

} // namespace complexes
