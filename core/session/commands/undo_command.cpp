#include "core/base/error.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json_fwd.hpp>

namespace session {

static void undo(Context& context, const nlohmann::json&) {
    if (!context.document.canUndo())
        throw base::Error("there is nothing to undo");
    context.document.undo();
}

static void redo(Context& context, const nlohmann::json&) {
    if (!context.document.canRedo())
        throw base::Error("there is nothing to redo");
    context.document.redo();
}

CommandRow undoCommand() {
    return {"undo", "Undo", "Goes back one step.", {}, true, false, undo, nullptr};
}

CommandRow redoCommand() {
    return {"redo", "Redo", "Redoes the step undone last.", {}, true, false, redo, nullptr};
}

} // namespace session
