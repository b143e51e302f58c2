#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runOrient(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    clean::commit(context,
                  clean::orient(context, surface, complete.at("method").get<std::string>(),
                                complete.value("viewpoint", nlohmann::json())),
                  "Orient normals", layers::How::Keep);
}

CommandRow orientCommand() {
    static const CommandParameter parameters[] = {
        {"method", "choice", "", clean::orientTip, "\"global\"", clean::orientWays, 0, 0},
        {"viewpoint", "list", "model units", clean::viewpointTip, "null", "", 0, 0},
    };
    return {"orient",
            "Orient normals",
            "Turns normals over until they agree which side is outside.",
            parameters,
            true,
            false,
            runOrient,
            nullptr};
}

} // namespace session
