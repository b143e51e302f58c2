// Forces over time as a picture: what `haptic --plot` writes, without fonts or a display.
#pragma once

#include "core/base/vec.h"
#include "core/render/renderer.h"

#include <vector>

namespace app {

struct FeltForce {
    double seconds = 0;
    base::Vec3d force;
    bool contact = false;
};

/// Size of the force dark, x, y and z in the colours of their axes, and a bar below where there is contact. Ticks
/// ascend in time.
render::Image forcePicture(const std::vector<FeltForce>& felt);

} // namespace app
