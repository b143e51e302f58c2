#include "core/base/error.h"
#include "core/io/formats.h"
#include "core/io/safe_file.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/journal.h"

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
    if (model.definition->boundary == surface::Boundary::Auto) // the part has rims that the whole has not
        model.definition->boundaryLimit = process::automaticBoundaryLimit(
            {tree::SurfelTree::build(model.points), *model.definition}, context.progress);
    model.faces = model.dropped = 0;
    model.elements.clear(); // they tell of surfels by number
    return model;
}

static void save(Context& context, const json& complete) {
    requireModel(context);
    const std::filesystem::path path = complete.at("path").get<std::string>();
    std::error_code unequal;
    if (context.journal && std::filesystem::equivalent(path, context.journal->path(), unequal))
        throw base::Error("is the journal of this session, which the model would replace", path.string(),
                          "choose another name");
    if (context.journal)
        context.journal->keepSource(path, context);
    const bool linked = io::hasOtherNames(path), whole = complete.at("part") == "all";
    const io::FileModel model =
        whole ? context.document.fileModel() : partOf(context, complete.at("part") == "selection");
    io::write(path, model, context.progress);
    if (const std::string loss = io::lossOf(path, model); !loss.empty())
        context.messages.push_back(loss);
    if (linked)
        context.messages.push_back(path.string() +
                                   ": other names of this file (hard links) still hold what it held before");
    if (whole && isNative(path))
        context.document.saved(path);
}

CommandRow saveCommand() {
    static const CommandParameter parameters[] = {
        {"path", "path", "", "file to write; its extension selects the format, .ply keeps everything", "", "", 0, 0},
        {"part", "choice", "", "selection, rest: that part of the model alone", "\"all\"", "all selection rest", 0, 0},
    };
    return {"save", "Save", "Writes the model to a file.", parameters, false, false, save, nullptr};
}

} // namespace session
