#include "core/selection/spread.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/selected/field_steps.h"

#include <nlohmann/json.hpp>

namespace session {

using selection::Field;

static void change(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface& surface = context.document.surface();
    const tree::SurfelTree next =
        complete.at("do") == "border"
            ? selection::combined(surface.tree(), selection::borderOf(surface), selection::Mode::Replace)
            : fieldChanged(context, Field::Selection, complete);
    commitSelection(context, next, "Change selection");
}

CommandRow selectionCommand() {
    static const CommandParameter parameters[] = {
        {"do", "choice", "", "border: what lies at the edge of it; copy: select as the mask has it", "",
         "invert grow shrink blur sharpen border clear copy", 0, 0},
        {"length", "number", "model units", fieldLengthTip, "null", "", positive, largest},
        {"strength", "number", "", fieldStrengthTip, "1", "", 0, 10},
    };
    return {
        "selection",
        "Change selection",
        "Inverts what is selected, lets it grow or shrink along the surface, smooths it, or takes it from the mask.",
        parameters,
        true,
        false,
        change,
        nullptr,
        HiddenParts::Spared};
}

} // namespace session
