// What `info` tells of a scene: its models, and how they stand.
#pragma once

#include "core/session/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

/// "selected" and "hidden": how many surfels are; no keys where nothing ever was.
void countParts(nlohmann::ordered_json& out, const tree::SurfelTree& tree);

/// surfels, bounds, models (as app/README 2.2 lists them), hash. Bounds are those of surfels
/// where they stand in the scene.
nlohmann::ordered_json infoOf(const session::Scene& scene);

} // namespace app
