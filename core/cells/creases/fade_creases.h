// Creases that give way under a brush (cells/README 8).
#pragma once

#include "core/surface/surface.h"

#include <functional>

namespace cells {

/// `share(position)`: how much of its sharpness a crease loses there, 0 to 1. In parallel. Models without cells stay as
/// they are, and so do those where nothing faded.
surface::Surface fadeCreases(const surface::Surface& surface, const std::function<double(const base::Vec3f&)>& share);

} // namespace cells
