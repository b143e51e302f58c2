#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

/// A script goes on, as a person would: that there is nothing is no reason to leave all else undone.
static void tellNothing(Context& context, const char* what) {
    context.messages.push_back(std::string("There is nothing to ") + what + ": the model is as it was.");
    context.instead = std::make_shared<nlohmann::json>(nlohmann::json::array()); // nor to record
}

static void undo(Context& context, const nlohmann::json&) {
    if (context.document.canUndo())
        context.document.undo();
    else
        tellNothing(context, "undo");
}

static void redo(Context& context, const nlohmann::json&) {
    if (context.document.canRedo())
        context.document.redo();
    else
        tellNothing(context, "redo");
}

CommandRow undoCommand() {
    return {"undo", "Undo", "Goes back one step.", {}, true, false, undo, nullptr};
}

CommandRow redoCommand() {
    return {"redo", "Redo", "Redoes the step undone last.", {}, true, false, redo, nullptr};
}

} // namespace session
