#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <nlohmann/json.hpp>

namespace session {

static void runOutliers(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const surface::Surface surface = context.document.surface();
    const surface::Surface left = clean::outliers(context, surface, complete.at("method").get<std::string>(),
                                                  complete.value("limit", nlohmann::json()));
    clean::commit(context, clean::guessedAgain(context, left), "Remove outliers");
}

CommandRow outliersCommand() {
    static const CommandParameter parameters[] = {
        {"method", "choice", "", clean::outlierTip, "\"statistical\"", clean::outlierWays, 0, 0},
        {"limit", "number", "", clean::limitTip, "null", "", 0, largest},
    };
    return {"outliers",
            "Remove outliers",
            "Takes out points that are not of the model; masked ones stay. Which way normals look that opening "
            "estimated is "
            "guessed again.",
            parameters,
            true,
            false,
            runOutliers,
            nullptr};
}

} // namespace session
