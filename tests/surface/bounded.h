// Definitions of surfaces that have a boundary.
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
