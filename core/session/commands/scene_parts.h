// Models of a scene taken apart and put together: parts of the command `scene`. Inside this room.
#pragma once

#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// Throws base::Error where a model cannot have the name.
void requireName(const Scene& scene, const std::string& name);
/// The name that the parameter `key` gives to a new model, else one like that of what it comes from.
std::string newName(const Scene& scene, const nlohmann::json& complete, const char* key, const std::string& like);

/// What is selected in the active model becomes a model, or each value of the attribute "by". Throws base::Error.
void splitModel(Context& context, const nlohmann::json& complete);
/// All that is shown and not locked goes into the active model. Throws base::Error.
void joinModels(Context& context, const nlohmann::json& complete);

} // namespace session
