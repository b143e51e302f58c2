// Files of poses that scanners' programs write beside range scans, one line for each scan:
//
//     bmesh bun045.ply tx ty tz qx qy qz qw
//
// With R the rotation of the unit quaternion, a point p of the scan stands at transpose(R) p + t. Lines of other kinds
// ("camera", comments) tell nothing of models. Such a file opens as a scene (scene_file.h). Inside this room only.
#pragma once

#include "core/process/registering/rigid.h"

#include <filesystem>
#include <vector>

namespace session {

/// By its name: NAME.conf.
bool isPoseFile(const std::filesystem::path& path);

struct PosedFile {
    std::filesystem::path file; ///< beside the file of poses
    process::Rigid pose;
};

/// At least one. Throws base::Error with the line that is wrong.
std::vector<PosedFile> posesIn(const std::filesystem::path& file);

} // namespace session
