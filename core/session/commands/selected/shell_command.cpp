#include "core/selection/shell.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/limits.h"

#include <nlohmann/json.hpp>

namespace session {

static void shell(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    requireSurface(context);
    const auto side = complete.at("side") == "out" ? selection::ShellSide::Out : selection::ShellSide::In;
    surface::Surface next = selection::shellOf(context.document.surface(), complete.at("thickness").get<double>(), side,
                                               limitOf(context, complete), context.progress);
    context.messages.push_back("The shell has " + std::to_string(next.tree().size()) + " surfels.");
    context.document.commit(std::move(next), "Shell");
}

CommandRow shellCommand() {
    static const CommandParameter parameters[] = {
        {"thickness", "number", "model units", "of the shell", "", "", positive, largest},
        {"side", "choice", "", "in: it grows behind the surface; out: before it", "\"in\"", "in out", 0, 0},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"shell",    "Shell", "Makes a solid shell of what is selected, and takes out the rest.",
            parameters, true,    false,
            shell,      nullptr};
}

} // namespace session
