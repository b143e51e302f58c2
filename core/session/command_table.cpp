#include "core/base/error.h"
#include "core/session/commands.h"

#include <array>

namespace session {

std::span<const CommandRow> commandTable() {
    static const std::array rows{openCommand(),     newCommand(),  saveCommand(), surfaceCommand(), strokeCommand(),
                                 resampleCommand(), undoCommand(), redoCommand(), expectCommand()};
    return rows;
}

const CommandRow& command(std::string_view op) {
    std::string known;
    for (const CommandRow& row : commandTable()) {
        if (row.op == op)
            return row;
        known += std::string(known.empty() ? "" : ", ") + row.op;
    }
    throw base::Error("unknown op \"" + std::string(op) + "\"", {}, "known are " + known);
}

void requireModel(const Context& context) {
    if (context.document.surface().tree().empty())
        throw base::Error("there is no model to work on", {}, "open one first, or make one with \"new\"");
}

} // namespace session
