// What the servo thread sees of a model: one version, with all that lies about the tool in memory (haptics/README 6.2).
//
// A patch is immutable and shared: the geometry thread makes it and is the last to let go of it.
#pragma once

#include "core/surface/surface.h"

#include <memory>

namespace haptics {

struct Patch {
    surface::Surface surface;
    double time = 0;  ///< when it was made, in the servo's clock
    base::Box3f warm; ///< what was read when it was made
};

using PatchPtr = std::shared_ptr<const Patch>;

/// A patch about a tool that may move up to `reach` before the next one.
PatchPtr makePatch(const surface::Surface& surface, const base::Vec3d& tool, double reach, double time);

} // namespace haptics
