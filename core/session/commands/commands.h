// The rows of the command table, one file each; command_table.cpp puts them in order. Inside this room only.
#pragma once

#include "core/session/command.h"

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace session {

CommandRow openCommand();
CommandRow newCommand();
CommandRow saveCommand();
CommandRow surfaceCommand();
CommandRow strokeCommand();
CommandRow touchCommand();
CommandRow resampleCommand();
CommandRow reduceCommand();
CommandRow refineCommand();
CommandRow fillCommand();
CommandRow bridgeCommand();
CommandRow extrudeCommand();
CommandRow cutCommand();
CommandRow trimCommand();
CommandRow solidCommand();
CommandRow primitiveCommand();
CommandRow drillCommand();
CommandRow tubeCommand();
CommandRow mergeCommand();
CommandRow mirrorCommand();
CommandRow hollowCommand();
CommandRow creaseCommand();
CommandRow registerCommand();
CommandRow measureCommand();
CommandRow shapesCommand();
CommandRow blendCommand();
CommandRow cleanCommand();
CommandRow duplicatesCommand();
CommandRow mixedCommand();
CommandRow outliersCommand();
CommandRow denoiseCommand();
CommandRow thinCommand();
CommandRow normalsCommand();
CommandRow orientCommand();
CommandRow upCommand();
CommandRow selectCommand();
CommandRow selectionCommand();
CommandRow maskCommand();
CommandRow deleteCommand();
CommandRow keepCommand();
CommandRow hideCommand();
CommandRow showCommand();
CommandRow duplicateCommand();
CommandRow transformCommand();
CommandRow colourCommand();
CommandRow levelsCommand();
CommandRow flipCommand();
CommandRow smoothCommand();
CommandRow sharpenCommand();
CommandRow inflateCommand();
CommandRow noiseCommand();
CommandRow alignCommand();
CommandRow unitCommand();
CommandRow shellCommand();
CommandRow layerCommand();
CommandRow sceneCommand();
CommandRow undoCommand();
CommandRow redoCommand();
CommandRow expectCommand();

/// Those of `stroke`.
std::vector<CommandParameter> strokeParameters();

/// Ranges that parameters name: any number that float32 holds; those above zero; those of no use as numbers.
constexpr double largest = CommandParameter::largest;
constexpr double positive = CommandParameter::positive;
constexpr double largestCount = 1e9;

/// Throws base::Error where no model is open yet.
void requireModel(const Context& context);

/// Another model that a command opened is the one whose hash was recorded: throws base::Error where it is not, or says
/// so where changed files are taken.
void requireRecorded(Context& context, const nlohmann::json& wanted, const base::Hash128& found,
                     const std::string& path);

/// The value of one parameter in the form that commands read. Throws base::Error where it does not fit.
nlohmann::json checked(const CommandRow& row, const std::string& id, const nlohmann::json& value);

/// The ids of a table's rows, separated by blanks, as CommandParameter::choices wants them.
template <class Table>
std::string idsOf(const Table& table) {
    std::string out;
    for (const auto& row : table)
        out += (out.empty() ? "" : " ") + std::string(row.id);
    return out;
}

} // namespace session
