// Definitions of surfaces that end at a rim.
#pragma once

#include "core/surface/definition.h"

namespace shapes {

inline surface::SurfaceDefinition bounded(float limit) {
    surface::SurfaceDefinition out;
    out.boundary = surface::Boundary::Limit;
    out.boundaryLimit = limit;
    return out;
}

} // namespace shapes
