#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/session/commands/commands.h"

#include <array>
#include <nlohmann/json.hpp>

namespace session {

std::span<const CommandRow> commandTable() {
    static const std::array rows{
        openCommand(),      newCommand(),       saveCommand(),       surfaceCommand(),   strokeCommand(),
        touchCommand(),     resampleCommand(),  reduceCommand(),     refineCommand(),    fillCommand(),
        bridgeCommand(),    extrudeCommand(),   cutCommand(),        trimCommand(),      solidCommand(),
        primitiveCommand(), drillCommand(),     tubeCommand(),       mergeCommand(),     mirrorCommand(),
        hollowCommand(),    creaseCommand(),    registerCommand(),   blendCommand(),     measureCommand(),
        shapesCommand(),    cleanCommand(),     duplicatesCommand(), mixedCommand(),     outliersCommand(),
        denoiseCommand(),   thinCommand(),      normalsCommand(),    orientCommand(),    upCommand(),
        selectCommand(),    selectionCommand(), maskCommand(),       deleteCommand(),    keepCommand(),
        hideCommand(),      showCommand(),      duplicateCommand(),  transformCommand(), colourCommand(),
        levelsCommand(),    flipCommand(),      smoothCommand(),     sharpenCommand(),   inflateCommand(),
        noiseCommand(),     alignCommand(),     unitCommand(),       shellCommand(),     layerCommand(),
        sceneCommand(),     undoCommand(),      redoCommand(),       expectCommand()};
    return rows;
}

const CommandRow& command(std::string_view op) {
    return base::rowOf(commandTable(), op, {"unknown op \"%\"", "", "known are %"}, &CommandRow::op);
}

void requireModel(const Context& context) {
    if (context.document.surface().tree().empty())
        throw base::Error("there is no model to work on", {}, "open one first, or make one with \"new\"");
}

void requireRecorded(Context& context, const nlohmann::json& wanted, const base::Hash128& found,
                     const std::string& path) {
    if (wanted == found.text())
        return;
    const std::string what = "the file is not the one that was recorded";
    if (!context.takesChangedFiles)
        throw base::Error(what, path, "restore that file, leave out the hash, or go on with it: run --anyway");
    context.messages.push_back(path + ": " + what + "; it is taken as it is now");
}

} // namespace session
