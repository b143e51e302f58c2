// Rims of open surfaces (alg. 6): where the off-centre value o(x) = |x - c(x)| reaches the definition's limit,
//
//     f(x) = 0,   o(x) = L h(x)        L = boundaryLimit, h(x) the weighted mean of the supports
//
// after A. Adamson, Computing Curves and Surfaces from Points (2007), chapter 6. On the surface x - c is tangential, so
// the rim is as smooth as c. A rim point is found by Newton's iteration on the two equations in the span of g and of
// the tangential part of grad (o^2/2) = (I - J)^T (x - c); the rim is followed along t = g x grad o^2, corrected by the
// same iteration. All of it is float64. Surfaces without a common sign work the same: the frame's sign is carried
// along.
//
// A rim needs a finite limit; without one there are no points and no rims.
#pragma once

#include "core/surface/surface.h"

#include <vector>

namespace surface {

struct RimPoint {
    base::Vec3d position;
    base::Vec3d normal;  ///< unit gradient of f
    base::Vec3d outward; ///< unit, along the surface and across the rim, away from the surface
    double unit = 0;     ///< h there

    /// Along the rim, unit: the surface lies to its left as seen from where the normal points.
    base::Vec3d tangent() const { return cross(normal, outward); }
};

struct RimSearch {
    Status status = Status::Outside;
    RimPoint point;
    int iterations = 0;

    bool ok() const { return status == Status::Ok; }
};

/// The rim point that Newton's iteration finds from `start`, to 1e-12 h; NotConverged where there is none near.
RimSearch findRimPoint(const Surface& surface, const base::Vec3d& start, const Hint& hint = {});

/// A rim as a polyline whose corners are rim points.
struct Rim {
    std::vector<RimPoint> points; ///< a closed rim does not repeat its first point
    bool closed = false;
    std::size_t surfels = 0; ///< how many surfels lead to it, where all rims were looked for

    /// Of the arcs between the points: each bends by the angle between its ends' tangents.
    double length() const;
};

struct TraceOptions {
    double turn = 0.1;         ///< angle that a step aims at, in radians
    double longestStep = 0.25; ///< in units of h
    double shortestStep = 1e-3;
    std::size_t mostPoints = 1000000;
};

/// Follows the rim from one of its points, both ways where it does not close. It ends where no next point is found.
Rim traceRim(const Surface& surface, const RimPoint& seed, const TraceOptions& options = {});

} // namespace surface
