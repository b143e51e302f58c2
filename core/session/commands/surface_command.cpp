#include "core/process/estimation/prepare.h"
#include "core/session/commands/commands.h"
#include "core/session/surface_options.h"

#include <nlohmann/json.hpp>

namespace session {

static void redefine(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface& now = context.document.surface();
    context.document.commit(process::redefine(now, changed(now.definition(), complete).definition, context.progress),
                            "Surface");
}

CommandRow surfaceCommand() {
    return {"surface",
            "Surface",
            "Changes how the points define their surface; options left out stay as they are.",
            surfaceParameters(),
            true,
            false,
            redefine,
            nullptr};
}

} // namespace session
