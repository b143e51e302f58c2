// One half of a model and its mirror image, welded at the plane (solid/README 4.1).
#pragma once

#include "core/base/plane.h"
#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <functional>

namespace solid {

/// What lies on the plane's positive side, twice: exactly symmetric. Images have the attributes of their surfels; sides
/// of frames are not mirrored. `settled` may give the half's attributes other values after it was welded and before it
/// is doubled. Throws base::Error where fewer than 4 surfels lie on that side; base::Cancelled.
surface::Surface mirrored(const surface::Surface& model, const base::Plane& plane, const base::Progress& progress = {},
                          const std::function<surfel::SurfelList(surfel::SurfelList half)>& settled = {});

} // namespace solid
