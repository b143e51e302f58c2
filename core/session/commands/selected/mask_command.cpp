#include "core/base/error.h"
#include "core/selection/blur.h"
#include "core/selection/hidden.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/field_steps.h"
#include "core/session/commands/selected/limits.h"

#include <nlohmann/json.hpp>

namespace session {

using selection::Field;

static tree::SurfelTree masked(Context& context, const nlohmann::json& complete) {
    const surface::Surface& surface = context.document.surface();
    const auto what = complete.at("do").get<std::string>();
    if (what == "cavity" || what == "curvature")
        requireSurface(context);
    if (what == "cavity")
        return selection::fromCavity(surface, Field::Mask, neededNumber(complete, "length"), complete.at("strength"),
                                     context.progress);
    if (what == "curvature") {
        const double low = complete.value("from", 0.0), high = neededNumber(complete, "to");
        if (!(low < high))
            throw base::Error("\"from\" is not below \"to\"", {}, "give the smaller curvature first");
        return selection::fromCurvature(surface, Field::Mask, low, high, context.progress);
    }
    return fieldChanged(context, Field::Mask, complete);
}

static void mask(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    clean::commit(context, {selection::hiddenSpared(now.tree(), masked(context, complete)), now.definition()},
                  "Change mask");
}

CommandRow maskCommand() {
    static const CommandParameter parameters[] = {
        {"do", "choice", "", "cavity: mask hollows; curvature: mask what is curved; copy: mask what is selected", "",
         "invert clear blur sharpen grow shrink cavity curvature copy", 0, 0},
        {"length", "number", "model units",
         "blur, sharpen, cavity: radius that means are taken over; grow, shrink: how far, along the surface", "null",
         "", positive, largest},
        {"strength", "number", "",
         "sharpen: 1 doubles the difference to the mean; cavity: 1 masks a hollow as wide as the "
         "length fully",
         "1", "", 0, 100},
        {"from", "number", "1 / model units", "curvature up to which surfels stay free; 0 unless told", "null", "", 0,
         largest},
        {"to", "number", "1 / model units", "curvature from which they are masked fully", "null", "", positive,
         largest},
    };
    return {"mask",
            "Change mask",
            "Inverts, clears, softens or hardens the mask that protects from tools, or makes one from the shape.",
            parameters,
            true,
            false,
            mask,
            nullptr,
            HiddenParts::Spared};
}

} // namespace session
