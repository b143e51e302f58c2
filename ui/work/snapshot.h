// What the window knows of the document: a value made on the model thread, shown on the interface's thread.
#pragma once

#include "core/session/document.h"
#include "core/session/scene/shown_scene.h"

namespace ui {

/// One model of the scene, as a list shows it.
struct SceneEntry {
    std::string name;
    std::size_t surfels = 0;
    bool visible = true, locked = false;
    bool operator==(const SceneEntry&) const = default;
};

/// What it tells of a model is of the scene's active one, whose stored coordinates are those of pictures and picks.
struct Snapshot {
    surface::Surface surface;   ///< with the dabs of a stroke in progress; of a curve, the tube around it
    surface::Surface reference; ///< the same as it was when opened, made or last saved
    std::size_t surfels = 0;    ///< of the model
    std::filesystem::path path;
    base::Vec3d origin;
    base::UpAxis up = base::UpAxis::Y;
    layers::Stack layers;
    std::vector<SceneEntry> scene; ///< all models in their order
    std::size_t active = 0;        ///< of them
    std::uint32_t model = 0;       ///< SceneModel::id of that one
    process::Rigid stand;          ///< from its stored coordinates to the scene's
    std::vector<session::ShownModel> beside;
    tree::SurfelTree whole; ///< `surface` and what is beside it: what pictures show
    bool modified = false;
    bool canUndo = false, canRedo = false;
    std::string undoLabel, redoLabel;
    std::vector<std::string> past, future; ///< what all steps are called: the oldest first, the next first
    std::size_t modelBytes = 0, historyBytes = 0;
    float spacing = 0;        ///< process::typicalSpacing, model units; 0 where there are too few
    float splatScale = 1;     ///< render::splatScaleOf the document's model
    double dabSeconds = 0;    ///< the last dab, resampling included
    std::uint64_t input = 0;  ///< the last pointer event of a stroke that it holds, as the interface counts them
    std::uint64_t models = 0; ///< grows when another model takes the place of the old one: frame it
};

/// Everything but `reference`, `dabSeconds`, `input` and `models`. Cost: blocks, not surfels, and of models beside the
/// active one what has changed since `shown` was asked last.
Snapshot snapshotOf(const session::Document& document, session::ShownScene& shown);

/// Is what is seen all of one model (RenderOptions::entire)?
bool isEntire(const Snapshot& snapshot);

} // namespace ui
