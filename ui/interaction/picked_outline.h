// An outline drawn over the picture, as parameters of the commands that work on what lies behind one. Free function of
// its arguments.
#pragma once

#include "ui/interaction/picker.h"

#include <nlohmann/json_fwd.hpp>

namespace ui {

/// eye, target, up, size, fov or ortho, and rectangle or polygon. `origin`: of stored coordinates, in those of
/// commands.
nlohmann::json outlineOf(const Pick& pick, PickShape shape, const base::Vec3d& origin);

} // namespace ui
