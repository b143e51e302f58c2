// A MODEL argument becomes a document, by the same commands that sessions use (session/model_argument.h).
#pragma once

#include "app/console.h"
#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>

namespace app {

/// What --help says about MODEL.
constexpr const char* modelHelp =
    "model file, - for standard input, or sample:NAME[:COUNT[:SEED]] for one made by code";

/// The points of the file or sample as they are, before anything is estimated; those of a scene where they stand in it.
/// `parameters`: of reading, may be empty; others are passed over.
io::FileModel readModel(const std::string& model, const nlohmann::json& parameters, const base::Progress& progress);

/// What a command does with the models of a scene.
enum class SceneUse {
    Active, ///< is about the active one alone, and says so: it comes with its pose applied, as `info` tells its bounds
    All,    ///< about all of them: the coordinates of the active one are the scene's, its pose being applied
    AsItIs, ///< knows of poses
};

/// Opens or makes the model. `surface`: parameters of the surface and of faces, may be empty. Messages go to the
/// console.
void openModel(session::Context& context, const std::string& model, const nlohmann::json& surface, Console& console,
               SceneUse use = SceneUse::Active);

/// The active model's pose goes into its points, so that its coordinates are the scene's. For documents that only
/// this command sees: locks give way.
void standInScene(session::Context& context);

/// Models are kept relative to origins of their own: one beside another is moved by the difference.
surface::Surface shifted(const surface::Surface& surface, const base::Vec3d& by);

} // namespace app
