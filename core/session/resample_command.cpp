#include "core/process/resample.h"
#include "core/session/commands.h"

#include <nlohmann/json.hpp>

namespace session {

static void resample(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const auto spacing = complete.at("spacing").get<float>();
    process::ResampleResult result = process::resampleAll(context.document.surface(), spacing, 12, context.progress);
    if (!result.settled)
        context.messages.push_back("resampling stopped after " + std::to_string(result.rounds) +
                                   " rounds, before the last points came to rest");
    context.document.commit(std::move(result.surface), "Resample");
}

CommandRow resampleCommand() {
    static const CommandParameter parameters[] = {
        {"spacing", "number", "model units", "distance of neighbouring points to reach", "", "", positive, largest},
    };
    return {"resample", "Resample", "Makes the points even, on the surface that they define now.",
            parameters, true,       false,
            resample,   nullptr};
}

} // namespace session
