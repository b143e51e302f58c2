#include "core/solid/mirror.h"

#include "core/session/commands/combined_model.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

static void mirror(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    base::Plane plane = planeOf(complete.at("plane").get<std::string>(), context.document.provenance().origin);
    if (complete.at("keep") == "below")
        plane = plane.flipped();
    context.document.commit(solid::mirrored(context.document.surface(), plane, context.progress), "Mirror");
}

CommandRow mirrorCommand() {
    static const CommandParameter parameters[] = {
        {"plane", "text", "", "the points where nx*x + ny*y + nz*z = d, as nx,ny,nz,d", "", "", 0, 0},
        {"keep", "choice", "", "which side is kept and mirrored; above is where the plane's normal points to",
         "\"above\"", "above below", 0, 0},
    };
    return {"mirror",   "Mirror", "Makes the model symmetric: one side and its mirror image, welded at a plane.",
            parameters, true,     false,
            mirror,     nullptr};
}

} // namespace session
