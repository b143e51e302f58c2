#include "core/base/error.h"
#include "core/selection/hidden.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"

#include <nlohmann/json.hpp>

namespace session {

static void commitHidden(Context& context, const tree::SurfelTree& next, const std::string& label) {
    const std::size_t count = sizeOf(selection::selectedIn(next, selection::Field::Hidden));
    context.figures["hidden"] = static_cast<double>(count);
    context.messages.push_back(std::to_string(count) + " of " + std::to_string(next.size()) + " surfels are hidden.");
    clean::commit(context, {next, context.document.surface().definition()}, label, layers::How::Keep);
}

static void hide(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    if (context.document.surface().definition().manifold == surface::Manifold::Complex)
        throw base::Error("parts of a complex cannot be hidden: its cells hold on to each other", {},
                          "hide parts of surfaces");
    const auto what = complete.at("what").get<std::string>();
    if (what == "selection" || what == "rest")
        requireSelection(context);
    if (what == "mask" && selection::selectedIn(context.document.surface().tree(), selection::Field::Mask).empty())
        throw base::Error("nothing is masked", {}, "mask what is to be hidden first");
    using selection::Hiding;
    commitHidden(context,
                 selection::hidden(context.document.surface().tree(), what == "selection" ? Hiding::Selected
                                                                      : what == "rest"    ? Hiding::Rest
                                                                      : what == "mask"    ? Hiding::Masked
                                                                                          : Hiding::Swap),
                 "Hide");
}

CommandRow hideCommand() {
    static const CommandParameter parameters[] = {
        {"what", "choice", "",
         "selection: what is selected; rest: what is not; mask: what is masked; swap: what is shown, and what is "
         "hidden is shown",
         "\"selection\"", "selection rest mask swap", 0, 0},
    };
    return {"hide",
            "Hide",
            "Hides a part of the model: it is not seen, and tools and rays pass it by. What is hidden is no longer "
            "selected; it is saved, meshed, measured and cut as before.",
            parameters,
            true,
            false,
            hide,
            nullptr,
            HiddenParts::Spared};
}

static void show(Context& context, const nlohmann::json&) {
    requireModel(context);
    commitHidden(context, selection::allShown(context.document.surface().tree()), "Show all");
}

CommandRow showCommand() {
    return {"show",  "Show all",         "Shows all that is hidden of the model.", {}, true, false, show,
            nullptr, HiddenParts::Spared};
}

} // namespace session
