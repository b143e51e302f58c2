// Cleaning a LAS file that is larger than memory, tile by tile (io/las/las_tiles.h), with the result that it has in one
// piece.
#pragma once

#include "core/base/progress.h"
#include "core/process/cleaning/find_outliers.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace app {

/// Whether a file would not fit in so much memory at once.
bool needsTiles(const std::string& in, std::uint64_t memory);

/// `command`: a complete command `clean`. Sentences for the person are appended to `messages`; the report is returned.
/// Throws base::Error for steps that need the whole file at once, and says why.
nlohmann::ordered_json cleanInTiles(const std::string& in, const std::string& out, const nlohmann::json& command,
                                    std::uint64_t memory, bool dryRun, std::vector<std::string>& messages,
                                    const base::Progress& progress);

} // namespace app
