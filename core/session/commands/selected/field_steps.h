// What `selection` and `mask` do alike to their fields. Inside this room.
#pragma once

#include "core/selection/field.h"
#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// "clear", "invert", "blur", "sharpen", "grow", "shrink" of a field, and what it takes from the other one ("copy").
tree::SurfelTree fieldChanged(Context& context, selection::Field field, const nlohmann::json& complete);

/// One step of history unless nothing changed, and how many surfels are selected now. What is hidden is not, unless
/// asked for.
void commitSelection(Context& context, tree::SurfelTree next, const std::string& label, bool hidden = false);

/// A parameter that some of a command's actions need. Throws base::Error naming it where it was left out.
double neededNumber(const nlohmann::json& complete, const char* id);

constexpr const char* fieldLengthTip =
    "blur, sharpen: radius that means are taken over; grow, shrink: how far, along the surface";
constexpr const char* fieldStrengthTip = "sharpen: by how much; 1 doubles the difference to the mean";

} // namespace session
