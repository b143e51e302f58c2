// The direction in which a covariance is least: where it is clear, without an iteration over all three.
#pragma once

#include "core/base/mat3.h"

namespace process {

/// Unit eigenvector of the least eigenvalue of a symmetric matrix without negative ones, to 1e-9; of no particular
/// sign. Where the two least are closer than some 1e-3 of the largest, what base::symmetricEigen makes of it.
base::Vec3d leastDirection(const base::Mat3d& covariance);

} // namespace process
