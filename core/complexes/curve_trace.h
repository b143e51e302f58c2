// A curve of a complex as a polyline, from one end to the other.
#pragma once

#include "core/complexes/complex.h"

namespace complexes {

/// Points on a curve and how far each is along it, in model units. Of a closed curve the last point is the first one.
struct TracedCurve {
    std::vector<base::Vec3d> points;
    std::vector<double> along;
    double spacing = 0; ///< of the curve's own points, about
    bool closed = false;

    double length() const { return along.empty() ? 0 : along.back(); }
    base::Vec3d at(double way) const;
    /// How far along the point is that is nearest to x.
    double wayOf(const base::Vec3d& x) const;
};

/// In steps of a quarter spacing, each projected. REQUIRES: a cell of dimension 1. What ends before its end, because
/// the points leave a gap, goes on there in a straight line.
TracedCurve trace(const Complex& complex, std::uint32_t curve);

} // namespace complexes
