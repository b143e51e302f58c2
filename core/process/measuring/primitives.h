// Planes, spheres, cylinders, cones and tori fitted to points by least squares of their geometric distances, where the
// points may be for a third something else (process/README 12.1).
//
// A start is found among many from a few points each, the one whose median distance is least; then Gauss-Newton steps
// with Marquardt's damping on the distances themselves, under weights that leave out what does not belong to it.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace process {

enum class Shape { Plane, Sphere, Cylinder, Cone, Torus };

/// All shapes in one: what a shape does not have stays zero.
struct Primitive {
    Shape shape = Shape::Plane;
    base::Vec3d place; ///< plane: the point nearest to the points' middle; sphere, torus: centre; cylinder: on the
                       ///< axis, likewise; cone: apex
    base::Vec3d axis;  ///< unit: the plane's normal; of the cone from the apex inwards; else the largest component > 0
    double radius = 0; ///< sphere, cylinder; torus: of the circle
    double tube = 0;   ///< torus: of the tube
    double angle = 0;  ///< cone: between axis and side, radians

    /// Signed: > 0 outside, or on the side that the plane's normal points to.
    double distance(const base::Vec3d& x) const;
};

struct PrimitiveFit {
    Primitive primitive;
    std::vector<std::uint8_t> inlier; ///< one per point
    std::size_t inliers = 0;
    double rms = 0, max = 0; ///< distances of the inliers
    double sigma = 0;        ///< robust standard deviation that decided who is one
};

struct ShapeRow {
    const char* id;
    Shape shape;
    std::size_t fewest; ///< points
};
std::span<const ShapeRow> shapeTable();

/// `normals` of the surfels start cylinders, cones and tori; they take no part in the fit. The same at any thread
/// count and for any order of the points up to rounding. Throws base::Error for too few points, or where nothing
/// fits; base::Cancelled.
PrimitiveFit fitPrimitive(const surfel::SurfelList& points, Shape shape, const base::Progress& progress = {});

} // namespace process
