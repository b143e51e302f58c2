#include "core/process/resampling/resample.h"
#include "core/session/commands.h"

#include <nlohmann/json.hpp>

namespace session {

static void resample(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    const auto spacing = complete.at("spacing").get<float>(), tolerance = complete.at("tolerance").get<float>();
    const surface::Surface& surface = context.document.surface();
    const process::CurvatureSpacing by{tolerance, spacing * complete.at("finest").get<float>(),
                                       spacing * complete.at("coarsest").get<float>()};
    process::ResampleResult result = tolerance > 0 ? process::resampleByCurvature(surface, by, 12, context.progress)
                                                   : process::resampleAll(surface, spacing, 12, context.progress);
    if (!result.settled)
        context.messages.push_back("resampling stopped after " + std::to_string(result.rounds) +
                                   " rounds, before the last points came to rest");
    context.document.commit(std::move(result.surface), "Resample");
}

CommandRow resampleCommand() {
    static const CommandParameter parameters[] = {
        {"spacing", "number", "model units", "distance between neighbouring points to reach", "", "", positive,
         largest},
        {"tolerance", "number", "model units",
         "above 0 the distance follows the curvature: the square root of tolerance over curvature, within the two "
         "limits; neighbouring distances differ by at most a tenth",
         "0", "", 0, largest},
        {"finest", "number", "spacings", "shortest distance, where it follows the curvature", "0.5", "", 0.01, 1},
        {"coarsest", "number", "spacings", "longest distance, where it follows the curvature", "2", "", 1, 100},
    };
    return {"resample", "Resample", "Spaces the points evenly on the surface that they define now.",
            parameters, true,       false,
            resample,   nullptr};
}

} // namespace session
