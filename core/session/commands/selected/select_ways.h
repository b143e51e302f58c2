// The ways in which `select` finds surfels: a row each with the parameters that have a say. Inside this room.
#pragma once

#include "core/session/command.h"
#include "core/tree/selection.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

struct SelectWay {
    const char* id;
    const char* needs; ///< parameters that must be there, separated by blanks
    const char* takes; ///< those that may
    tree::Selection (*find)(Context&, const nlohmann::json& complete);
};
std::span<const SelectWay> selectWays();

/// What the way named by "by" finds. Throws base::Error where a parameter is missing or has no say.
tree::Selection found(Context& context, const nlohmann::json& complete);

} // namespace session
