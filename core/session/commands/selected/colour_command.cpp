#include "core/base/error.h"
#include "core/selection/hidden.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/number_lists.h"

#include <nlohmann/json.hpp>

namespace session {

static void colour(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    const tree::SurfelTree next = selection::coloured(
        now.tree(), colourOf(complete, "colour"), complete.at("strength").get<double>(), limitOf(context, complete));
    clean::commit(context, {selection::hiddenSpared(now.tree(), next), now.definition()}, "Colour");
}

CommandRow colourCommand() {
    static const CommandParameter parameters[] = {
        {"colour", "list", "", "[red,green,blue] from 0 to 255", "", "", 0, 0},
        {"strength", "number", "", "1: this colour, less: on the way to it", "1", "", 0, 1},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"colour",   "Colour", "Fills what is selected with a colour; soft selections shade into what is around.",
            parameters, true,     false,
            colour,     nullptr,  HiddenParts::Spared};
}

static void flip(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    if (!now.tree().layout()->normals)
        throw base::Error("the model has no normals to turn over", {}, "make them with \"normals\"");
    clean::commit(context, {selection::flipped(now.tree(), limitOf(context, complete)), now.definition()},
                  "Flip normals", layers::How::Keep);
}

CommandRow flipCommand() {
    static const CommandParameter parameters[] = {
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"flip", "Flip normals", "Turns inside out: normals point to the other side.", parameters, true, false,
            flip,   nullptr};
}

} // namespace session
