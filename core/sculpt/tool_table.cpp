#include "core/base/error.h"
#include "core/sculpt/tool.h"
#include "core/sculpt/tools/clay.h"
#include "core/sculpt/tools/draw.h"
#include "core/sculpt/tools/grab.h"
#include "core/sculpt/tools/smooth.h"

namespace sculpt {

/// In the order of the tool bar. Copied at the first call, when the rows of the other files exist.
std::span<const ToolRow> toolTable() {
    static const ToolRow rows[] = {drawTool, clayTool, smoothTool, grabTool};
    return rows;
}

const ToolRow& tool(std::string_view id) {
    std::string known;
    for (const ToolRow& row : toolTable()) {
        if (id == row.id)
            return row;
        known += known.empty() ? row.id : std::string(", ") + row.id;
    }
    throw base::Error("there is no tool '" + std::string(id) + "'", "tool", "choose one of " + known);
}

} // namespace sculpt
