#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runNormals(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    clean::commit(context,
                  clean::normals(context, surface, complete.at("method").get<std::string>(),
                                 complete.value("viewpoint", nlohmann::json())),
                  "Estimate normals", layers::How::Keep);
}

CommandRow normalsCommand() {
    static const CommandParameter parameters[] = {
        {"method", "choice", "", clean::normalTip, "\"plane\"", clean::normalWays, 0, 0},
        {"viewpoint", "list", "model units", clean::viewpointTip, "null", "", 0, 0},
    };
    return {"normals",
            "Estimate normals",
            "Makes normals anew from the positions, on the side of those that there are.",
            parameters,
            true,
            false,
            runNormals,
            nullptr};
}

} // namespace session
