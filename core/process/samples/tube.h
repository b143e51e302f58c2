// Tubes around closed curves (torus, knot), sampled evenly: rows run along the tube in a rotation-minimising frame, so
// that neighbouring rows keep their distance, and points stand at equal arc lengths along each row.
#pragma once

#include "core/surfel/surfel.h"

#include <functional>

namespace process {

struct Tube {
    std::function<base::Vec3d(double)> centre;  ///< closed curve of period 2 pi
    std::function<base::Vec3d(double)> tangent; ///< its derivative, any length but zero
    double radius = 0;                          ///< REQUIRES: less than every radius of curvature
};

/// `count` surfels with outward normals, exactly on the tube.
surfel::SurfelList sampleTube(const Tube& tube, std::size_t count);

} // namespace process
