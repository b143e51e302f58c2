// The models that a file holds: one, or several where a scene was saved in it. The same for `open`, which replaces the
// document's, and `scene`, which adds them.
#pragma once

#include "core/base/progress.h"
#include "core/session/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// `path` is what the file is called, `source` where it is read. `parameters`: of faces and surface. What a person
/// should know is appended to `messages`. Throws base::Error, base::Cancelled.
Scene readModels(const std::filesystem::path& path, const std::filesystem::path& source,
                 const nlohmann::json& parameters, std::vector<std::string>& messages, const base::Progress& progress);

/// The same of a file that is read already.
Scene modelsOf(io::FileModel file, const std::filesystem::path& path, const nlohmann::json& parameters,
               std::vector<std::string>& messages, const base::Progress& progress);

} // namespace session
