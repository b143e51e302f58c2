#include "core/process/estimation/boundary_limit.h"
#include "core/selection/parts.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"

#include <nlohmann/json.hpp>

namespace session {

static void take(Context& context, const tree::SurfelTree& next, const std::string& label) {
    const surface::Surface& now = context.document.surface();
    context.messages.push_back(std::to_string(now.tree().size() - next.size()) + " surfels were taken out, " +
                               std::to_string(next.size()) + " are left.");
    const surface::Surface left = next == now.tree() ? now // else it has rims where it was cut
                                                     : process::withOwnLimit(next, now.definition(), context.progress);
    clean::commit(context, left, label);
}

static void deleteSelected(Context& context, const nlohmann::json&) {
    requireModel(context);
    requireSelection(context);
    take(context, selection::withoutSelected(context.document.surface().tree()), "Delete");
}

CommandRow deleteCommand() {
    return {"delete",       "Delete", "Takes out what is selected; what stays keeps every bit.", {}, true, false,
            deleteSelected, nullptr};
}

static void keepSelected(Context& context, const nlohmann::json&) {
    requireModel(context);
    requireSelection(context);
    take(context, selection::withoutRest(context.document.surface().tree()), "Keep");
}

CommandRow keepCommand() {
    return {"keep",       "Keep", "Takes out all that is not selected; what stays keeps every bit.", {}, true, false,
            keepSelected, nullptr};
}

} // namespace session
