#include "core/selection/hidden.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"

#include <nlohmann/json.hpp>

namespace session {

/// All that is left may be hidden: then it is shown.
static void take(Context& context, tree::SurfelTree next, const std::string& label) {
    const surface::Surface& now = context.document.surface();
    const bool unseen = next.size() > 0 && sizeOf(selection::selectedIn(next, selection::Field::Hidden)) == next.size();
    if (unseen)
        next = selection::allShown(next);
    context.messages.push_back(std::to_string(now.tree().size() - next.size()) + " surfels were taken out, " +
                               std::to_string(next.size()) + (unseen ? " that were hidden are left." : " are left."));
    clean::commit(context, next == now.tree() ? now : selection::asPart(now, next, context.progress), label);
}

static void deleteSelected(Context& context, const nlohmann::json&) {
    requireModel(context);
    requireSelection(context);
    take(context, selection::withoutSelected(context.document.surface().tree()), "Delete");
}

CommandRow deleteCommand() {
    return {"delete",
            "Delete",
            "Takes out what is selected; what stays keeps every bit.",
            {},
            true,
            false,
            deleteSelected,
            nullptr,
            HiddenParts::Spared};
}

static void keepSelected(Context& context, const nlohmann::json&) {
    requireModel(context);
    requireSelection(context);
    take(context, selection::withoutRest(context.document.surface().tree()), "Keep");
}

CommandRow keepCommand() {
    return {"keep",       "Keep",  "Takes out all that is not selected; what stays keeps every bit.",
            {},           true,    false,
            keepSelected, nullptr, HiddenParts::Spared};
}

} // namespace session
