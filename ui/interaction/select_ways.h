// The ways to select with the pointer: one table, over which the bar, the window and tests loop. Each makes of a pick
// the command `select` that a session would hold.
#pragma once

#include "core/surface/surface.h"
#include "ui/interaction/picker.h"

#include <nlohmann/json_fwd.hpp>
#include <span>

namespace ui {

/// What a way goes by, beside the pick.
struct SelectContext {
    const surface::Surface& surface;
    base::Vec3d origin;  ///< of stored coordinates, in those of commands
    double radius = 0;   ///< of the brush at the pick, model units
    bool visible = true; ///< outlines take only what is seen
};

struct SelectWay {
    const char* id; ///< "rectangle"
    const char* label;
    const char* tip;
    PickShape shape;
    /// Without `mode`.
    nlohmann::json (*command)(const Pick& pick, const SelectContext& context);
};
std::span<const SelectWay> selectWays();

/// The mode that keys held at a pick ask for, else `chosen`.
const char* modeOf(Qt::KeyboardModifiers modifiers, const char* chosen);

} // namespace ui
