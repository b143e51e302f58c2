#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runThin(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    clean::commit(context, clean::thin(context, surface, complete.at("spacing").get<float>()), "Thin");
}

CommandRow thinCommand() {
    static const CommandParameter parameters[] = {
        {"spacing", "number", "model units", clean::spacingTip, "", "", positive, largest},
    };
    return {"thin",
            "Thin",
            "Keeps some of the points, each where it is, as many as can stand so far apart; masked ones stay.",
            parameters,
            true,
            false,
            runThin,
            nullptr};
}

} // namespace session
