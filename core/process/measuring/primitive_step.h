// One damped Gauss-Newton iteration after the other for a primitive (primitives.h). Inside this folder.
#pragma once

#include "core/process/measuring/primitives.h"

namespace process {

/// Sum of weighted squared distances minimised from a start. A weight below 1 is Tukey's, by the residual over `reach`;
/// infinity: least squares of all. Points are in units of about 1 around the origin. Throws base::Cancelled.
Primitive descend(const Primitive& start, std::span<const base::Vec3d> points, double reach, int iterations);

} // namespace process
