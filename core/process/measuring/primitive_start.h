// Starts for fits (primitives.h): the shape through as few points as determine it. Inside this folder.
#pragma once

#include "core/process/measuring/primitives.h"

namespace process {

struct OrientedPoint {
    base::Vec3d position, normal; ///< the sign of the normal means nothing
};

/// How many points a start is made of.
std::size_t startPoints(Shape shape);

/// Nothing where these do not determine one. REQUIRES: startPoints(shape) of them.
std::optional<Primitive> startFrom(Shape shape, std::span<const OrientedPoint> points);

} // namespace process
