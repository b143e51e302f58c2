// Which of the cells around a place is surface (cells/README 3): the solid is the local Boolean of its patches, their
// intersection where they meet in convex creases and their union at concave ones.
#pragma once

#include "core/cells/cell_source.h"

namespace cells {

/// Is the level set of cell i through the source's position cut off by another cell: is f of one that it meets in a
/// convex crease larger by more than `tolerance`, or of one at a concave crease smaller? At reflex corners of a face,
/// which ends at neither of two creases alone, by both.
bool cutOff(CellSource& source, std::size_t i, double tolerance);

/// Would a zero of cell i at the source's position be surface? The frame is valid, the off-centre values are within
/// the limits, f is steep enough along its normal (surface/README 4.4), and nothing cuts it off.
bool isFace(CellSource& source, std::size_t i, double tolerance);

/// By how much f may be beyond another cell's, in units of h, where both are equal but for rounding; `far` is the size
/// of coordinates.
double cutTolerance(double unit, double far);

} // namespace cells
