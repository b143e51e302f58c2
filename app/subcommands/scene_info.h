// What `info` tells of a scene: its models, and how they stand.
#pragma once

#include "core/session/document.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

/// Whether MODEL holds a scene: a scene file, or what the file holds is the parts of one.
bool isScene(const std::string& model, const io::FileModel* file);

/// surfels, bounds, models (name, surfels, bounds, visible, locked, active, matrix), hash. Bounds are those of surfels
/// where they stand in the scene.
nlohmann::ordered_json infoOf(const session::Document& document);

} // namespace app
