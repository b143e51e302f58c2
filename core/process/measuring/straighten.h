// A way on a surface drawn tight: a geodesic (process/README 12.3).
//
//     E = sum |p_{i+1} - p_i|^2 / t_i        p_i on the surface, t_i as long as the surface resolves there
//
// is made least over all points but the first and last by Newton's method in their tangent planes: a chain of 2 x 2
// blocks, with the surface's own curvature (second derivatives of f) and Marquardt's damping. Points then lie t_i apart
// on a way that bends only with the surface. Where the surface ends they slide along its rim. All of it is float64.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <optional>
#include <span>
#include <vector>

namespace process {

struct GeodesicPoint {
    base::Vec3d position;
    base::Vec3d normal; ///< unit gradient of f
    double unit = 0;    ///< h there
    bool rim = false;   ///< held by the boundary
};

struct Geodesic {
    std::vector<GeodesicPoint> points;
    bool closed = false;
    double length = 0; ///< of the arcs between the points
};

/// The geodesic that a polyline near the surface becomes; its first and last places are projected and stay. None where
/// the surface has gaps that it would have to leap over. The same bits at any thread count. Throws base::Cancelled.
std::optional<Geodesic> straightened(const surface::Surface& surface, std::span<const base::Vec3d> way,
                                     const base::Progress& progress = {});

} // namespace process
