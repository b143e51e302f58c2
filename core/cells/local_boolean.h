// Which of the cells around a place is surface (cells/README 3): the solid is the local Boolean of its patches, their
// intersection where they meet in convex creases and their union at concave ones.
#pragma once

#include "core/cells/cell_source_float.h"

namespace cells {

/// Is the level set of cell i through the source's position cut off by another cell: is f of one that it meets in a
/// convex crease larger by more than `tolerance`, or of one at a concave crease smaller? At reflex corners of a face,
/// which ends at neither of two creases alone, by both.
template <class Source>
bool cutOff(Source& source, std::size_t i, double tolerance);

/// The plane of the cell that does so most, of those that have no value there: with too few surfels in support, or, as
/// they are sampled more finely, with none (cells/README 3).
std::optional<CellSource::Tangent> cutOffByPlane(CellSource& source, std::size_t i, double tolerance);

/// What ends cell i at the source's position in place of a cell that has no surfels in support: the plane of the
/// nearest one, as long as that is near.
std::optional<CellSource::Tangent> planeOf(CellSource& source, std::size_t i, const AbsentCell& absent);

/// Is the off-centre value of cell i at the source's position larger than the boundary limit, the surfels of cells that
/// it meets laid out flat as its own are? At an edge, however acute, the surface does not end.
template <class Source>
bool beyondBoundary(Source& source, std::size_t i);

/// Would a zero of cell i at the source's position be surface? The frame is valid, the off-centre values are within
/// the limits, f is steep enough along its normal (surface/README 4.4), and nothing cuts it off.
template <class Source>
bool isFace(Source& source, std::size_t i, double tolerance);

extern template bool cutOff(CellSource&, std::size_t, double);
extern template bool cutOff(CellSourcef&, std::size_t, double);
extern template bool beyondBoundary(CellSource&, std::size_t);
extern template bool beyondBoundary(CellSourcef&, std::size_t);
extern template bool isFace(CellSource&, std::size_t, double);
extern template bool isFace(CellSourcef&, std::size_t, double);

/// By how much f may be beyond another cell's, in units of h, where both are equal but for rounding; `far` is the size
/// of coordinates.
double cutTolerance(double unit, double far);
inline double cutTolerance(const CellSource&, double unit, double far) {
    return cutTolerance(unit, far);
}
/// The same for values in float.
double cutTolerance(const CellSourcef& source, double unit, double far);

} // namespace cells
