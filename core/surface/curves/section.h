// Plane sections: where the surface meets a plane,
//
//     f(x) = 0,   n.x = d
//
// as polylines whose corners fulfil both to rounding. A point is found by Newton's iteration inside the plane, along
// the part of g in it; the curve is followed along t = n x g and corrected by the same iteration (curve_tracing.h).
// Loops close; at a boundary, and where f stops being surface (intersect.h: minSlope, maxOffCentre), the curve ends.
// All of it is float64. Surfaces without a common sign work the same.
//
// Where the surface touches the plane without crossing it there is no curve, and none is reported.
#pragma once

#include "core/base/plane.h"
#include "core/base/progress.h"
#include "core/surface/curves/boundary.h"

namespace surface {

struct SectionPoint {
    base::Vec3d position;
    base::Vec3d normal; ///< unit gradient of f
    base::Vec3d along;  ///< unit, n x g: counter-clockwise about what is inside, seen from where the plane's normal is
    double unit = 0;    ///< h there

    const base::Vec3d& tangent() const { return along; }
};

/// The point of the section that Newton's iteration finds from `start`, to 1e-12 h; nothing where there is none near.
/// It may lie beyond a boundary.
struct SectionSearch {
    Status status = Status::Outside;
    SectionPoint point;
    bool surface = false; ///< does the surface reach there?
    int iterations = 0;

    bool ok() const { return status == Status::Ok; }
};
SectionSearch findSectionPoint(const Surface& surface, const base::Plane& plane, const base::Vec3d& start,
                               const OrientationHint& hint = {});

/// Places of the surfels that look for the section: those so near to the plane for their support that whatever it cuts
/// has one; in tree order. Costs what these cost.
std::vector<base::Vec3d> surfelsNear(const tree::SurfelTree& tree, const base::Plane& plane);

/// One curve of a section; a closed one does not repeat its first point.
struct SectionCurve {
    std::vector<SectionPoint> points;
    bool closed = false;

    double length() const; ///< of the arcs between the points
    /// Of a closed curve, in the plane: > 0 where it runs around what is inside.
    double area(const base::Plane& plane) const;
};

/// All curves of the section, longest first. Costs what the surfels near the plane cost. The same bits at any thread
/// count. Throws base::Cancelled.
std::vector<SectionCurve> findSection(const Surface& surface, const base::Plane& plane,
                                      const base::Progress& progress = {}, const TraceOptions& options = {});

} // namespace surface
