// What the validator found, as a table for people and as JSON for scripts (app/README 2.4, mesh/README 6).
#pragma once

#include "core/mesh/check/check.h"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace app {

/// Lengths in model units and in spacings.
std::string reportTable(const mesh::Report& report, double spacing);
nlohmann::json reportJson(const mesh::Report& report, double spacing);

} // namespace app
