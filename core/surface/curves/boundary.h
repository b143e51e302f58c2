// Boundaries of open surfaces (surface/README 5.3): where the off-centre value o(x) = |x - c(x)| reaches the
// definition's limit,
//
//     f(x) = 0,   o(x) = L h(x)        L = boundaryLimit, h(x) the weighted mean of the supports
//
// [Adamson07, 6]. On the surface x - c is tangential, so the boundary is as smooth as c. Newton's iteration finds a
// point of it from the two equations, in the span of g and of the tangential part of grad (o^2/2) = (I - J)^T (x - c);
// the curve is followed along t = g x grad o^2 and corrected by the same iteration. Everything is float64. Surfaces
// without a common sign work the same: the frame's sign is carried along.
//
// A boundary needs a finite limit; without one there are neither points nor curves.
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace surface {

struct BoundaryPoint {
    base::Vec3d position;
    base::Vec3d normal;  ///< unit gradient of f
    base::Vec3d outward; ///< unit, along the surface and across the boundary, away from the surface
    double unit = 0;     ///< h there

    /// Along the boundary, unit: the surface lies to its left as seen from where the normal points.
    base::Vec3d tangent() const { return cross(normal, outward); }
};

struct BoundarySearch {
    Status status = Status::Outside;
    BoundaryPoint point;
    int iterations = 0;

    bool ok() const { return status == Status::Ok; }
};

/// The boundary point that Newton's iteration finds from `start`, to 1e-12 h; NotConverged where there is none near.
BoundarySearch findBoundaryPoint(const Surface& surface, const base::Vec3d& start, const OrientationHint& hint = {});

/// A polyline whose corners are boundary points. A closed one is a boundary loop.
struct BoundaryCurve {
    std::vector<BoundaryPoint> points; ///< a loop does not repeat its first point
    bool closed = false;
    std::size_t surfels = 0; ///< how many surfels lead to it, where all curves were looked for

    /// Of the arcs between the points: each bends by the angle between its ends' tangents.
    double length() const;
};

struct TraceOptions {
    double turn = 0.1;         ///< angle that a step aims at, in radians
    double longestStep = 0.25; ///< in units of h
    double shortestStep = 1e-3;
    std::size_t mostPoints = 1000000;
};

/// Follows the boundary from one of its points, both ways where it does not close. It ends where no next point is
/// found.
BoundaryCurve traceBoundary(const Surface& surface, const BoundaryPoint& seed, const TraceOptions& options = {});

} // namespace surface
