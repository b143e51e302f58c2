// Scene files: a small JSON file that names a file for each model, and how the models stand to each other.
//
//     {"pointclay-scene": 1, "active": "bust", "models": [
//        {"name": "bust", "file": "desk.bust.ply", "matrix": [16 numbers by row], "visible": true, "locked": false}]}
//
// Files are named from the folder of the scene file; "matrix", "visible" and "locked" may be left out. A scene is
// opened by the commands that would put it together, so that a journal reads and keeps each model's file like any
// other.
#pragma once

#include "core/session/scene/scene.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

/// By its name: NAME.scene.json, which is how scenes are saved.
bool isSceneFile(const std::filesystem::path& path);
/// What opens as several models: those, and files of scans' poses (pose_file.h).
bool opensAsScene(const std::filesystem::path& path);

/// Throws base::Error where neither a scene nor a model is written to files of that extension.
void requireSavable(const std::filesystem::path& path);

/// The commands that make the scene, the first of which opens a model. Scans that a file of poses names and that are
/// not there are left out, which is told. Throws base::Error that names what is wrong.
std::vector<nlohmann::json> sceneCommands(const std::filesystem::path& file, std::vector<std::string>& messages);

/// Where the models of a scene are saved that is saved in `file`: beside it, in the models' order, over the files of an
/// earlier save and over no others.
std::vector<std::filesystem::path> modelFiles(const Scene& scene, const std::filesystem::path& file);

/// The scene file's text, for models in these files.
std::string sceneText(const Scene& scene, const std::vector<std::filesystem::path>& files);

} // namespace session
