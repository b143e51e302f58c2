#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runMixed(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface left =
        clean::mixed(context, context.document.surface(), complete.value("viewpoint", nlohmann::json()),
                     complete.at("limit").get<double>());
    clean::commit(context, clean::guessedAgain(context, left, complete.value("viewpoint", nlohmann::json())),
                  "Remove mixed pixels");
}

CommandRow mixedCommand() {
    static const CommandParameter parameters[] = {
        {"viewpoint", "list", "model units", clean::eyeTip, "null", "", 0, 0},
        {"limit", "number", "beams apart", clean::stepTip, "2", "", 0, largest},
    };
    return {
        "mixed",
        "Remove mixed pixels",
        "Takes out points that a scanner measured half on the near and half on the far side of an edge: veils along "
        "the line of sight between two surfaces; masked ones stay.",
        parameters,
        true,
        false,
        runMixed,
        nullptr};
}

} // namespace session
