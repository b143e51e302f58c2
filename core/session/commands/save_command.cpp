#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/journal.h"
#include "core/session/scene/scene_file.h"
#include "core/session/scene/scene_ply.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// PLY is the native format: what it holds is all there is. In other formats the document remains unsaved.
static bool isNative(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return extension == ".ply";
}

/// What is selected, or all else, as a model of its own.
static io::FileModel partOf(Context& context, bool selected) {
    requireSelection(context);
    io::FileModel model = context.document.fileModel();
    model.points = selection::partOf(context.document.surface().tree(), selected);
    if (model.points.items.empty())
        throw base::Error("everything is selected, so that there is no rest", {}, "select less");
    model.shape = {};
    const surface::Surface part =
        selection::asPart(context.document.surface(), tree::SurfelTree::build(model.points), context.progress);
    model.definition = part.definition();
    model.points = part.tree().surfels(); // which may know their rims now
    model.faces = model.dropped = 0;
    model.elements.clear(); // they tell of surfels by number
    return model;
}

/// Nothing is written over that the journal still needs.
static void makeWay(Context& context, const std::filesystem::path& path) {
    std::error_code unequal;
    if (context.journal && std::filesystem::equivalent(path, context.journal->path(), unequal))
        throw base::Error("is the journal of this session, which the model would replace", path.string(),
                          "choose another name");
    if (context.journal)
        context.journal->keepSource(path, context);
}

static void write(Context& context, const std::filesystem::path& path, const io::FileModel& model) {
    makeWay(context, path);
    const bool linked = io::hasOtherNames(path);
    io::write(path, model, context.progress);
    if (const std::string loss = io::lossOf(path, model); !loss.empty())
        context.messages.push_back(loss);
    if (linked)
        context.messages.push_back(path.string() +
                                   ": other names of this file (hard links) still hold what it held before");
}

/// A file for each model, then the one that names them.
static void saveScene(Context& context, const std::filesystem::path& path) {
    const Scene& scene = context.document.scene();
    makeWay(context, path);
    const std::vector<std::filesystem::path> files = modelFiles(scene, path);
    for (std::size_t k = 0; k < files.size(); ++k)
        write(context, files[k], fileModel(scene.models[k]));
    io::writeFile(path, sceneText(scene, files));
    context.messages.push_back(std::to_string(files.size()) + (files.size() == 1 ? " model" : " models") +
                               " in files beside it: " + path.stem().stem().string() + ".NAME.ply");
    context.document.saved(path);
}

/// Other programs know nothing of hidden models.
static Scene shownOf(const Scene& scene) {
    Scene out = scene;
    std::erase_if(out.models, [](const SceneModel& each) { return !each.visible; });
    out.active = 0;
    return out.models.empty() ? scene : out;
}

static void tellOfTogether(Context& context, const Scene& scene, bool native) {
    const auto posed = std::ranges::count_if(scene.models, [](const auto& each) { return !isNothing(each.pose); });
    if (posed > 0)
        context.messages.push_back("Places are in the points now: " + std::to_string(posed) +
                                   (posed == 1 ? " model has no pose" : " models have no poses") +
                                   " in this file; .scene.json keeps them.");
    if (native)
        return;
    const std::size_t hidden = context.document.scene().models.size() - scene.models.size();
    context.messages.push_back(std::to_string(scene.models.size()) + " models are written as one cloud" +
                               (hidden > 0 ? ", and " + std::to_string(hidden) + " that are hidden left out" : "") +
                               "; .ply and .scene.json keep them apart.");
}

/// All that there is, as one file.
static io::FileModel wholeOf(Context& context, const std::filesystem::path& path) {
    const Scene& scene = context.document.scene();
    if (scene.models.size() == 1 && isNothing(scene.models.front().pose))
        return context.document.fileModel();
    const Scene written = isNative(path) ? scene : shownOf(scene);
    tellOfTogether(context, written, isNative(path));
    return togetherAsParts(written);
}

static void save(Context& context, const json& complete) {
    requireModel(context);
    const std::filesystem::path path = complete.at("path").get<std::string>();
    const auto part = complete.at("part").get<std::string>();
    if (isSceneFile(path)) {
        if (part != "all")
            throw base::Error("a scene file holds all models", path.string(), "save a part as .ply");
        return saveScene(context, path);
    }
    if (part == "all")
        write(context, path, wholeOf(context, path));
    else
        write(context, path, part == "model" ? context.document.fileModel() : partOf(context, part == "selection"));
    const bool whole = part == "all" || (part == "model" && context.document.scene().models.size() == 1);
    if (whole && isNative(path))
        context.document.saved(path);
}

CommandRow saveCommand() {
    static const CommandParameter parameters[] = {
        {"path", "path", "",
         "file to write; its extension selects the format; .ply keeps everything, of several models where they stand "
         "instead of poses; NAME.scene.json keeps these, too, with a file for each model",
         "", "", 0, 0},
        {"part", "choice", "", "model: the active one alone; selection, rest: that part of it", "\"all\"",
         "all model selection rest", 0, 0},
    };
    return {"save", "Save", "Writes the model to a file.", parameters, false, false, save, nullptr};
}

} // namespace session
