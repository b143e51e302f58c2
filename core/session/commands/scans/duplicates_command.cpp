#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runDuplicates(Context& context, const nlohmann::json&) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    clean::commit(context, clean::duplicates(context, surface), "Merge duplicates");
}

CommandRow duplicatesCommand() {
    return {"duplicates",
            "Merge duplicates",
            "Merges points that stand in one place; the first of them stays.",
            {},
            true,
            false,
            runDuplicates,
            nullptr};
}

} // namespace session
