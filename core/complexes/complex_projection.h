// The projection onto a whole complex, and f there: of the patch that is nearest [Adamson07, 9].
#pragma once

#include "core/complexes/foot_on_cell.h"

#include <span>

namespace complexes {

/// The nearest of the feet on all cells that bound no other; the others' feet are among them. From anywhere.
CellFoot project(const Complex& complex, const base::Vec3d& x, surface::Projector projector);

/// f = n . (x - c) of the patch that x projects to, or of one that its foot bounds; Outside where the nearest cell is
/// no patch's, or x is beyond all supports. Off-centre values are those of the patch's own points.
surface::Evaluationd evaluate(const Complex& complex, const base::Vec3d& x, surface::Need need);

} // namespace complexes
