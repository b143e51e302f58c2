// One half of a model and its mirror image, welded at the plane (solid/README 4.1).
#pragma once

#include "core/base/plane.h"
#include "core/base/progress.h"
#include "core/surface/surface.h"

namespace solid {

/// What lies on the plane's positive side, twice: exactly symmetric. Attributes are mirrored with their surfels, sides
/// of frames are not. Throws base::Error where fewer than 4 surfels lie on that side; base::Cancelled.
surface::Surface mirrored(const surface::Surface& model, const base::Plane& plane, const base::Progress& progress = {});

} // namespace solid
