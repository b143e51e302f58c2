#include "core/base/error.h"
#include "core/base/short_number.h"
#include "core/cells/measured_labels.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/resample.h"
#include "core/session/commands/commands.h"

#include <nlohmann/json.hpp>

namespace session {

/// By the one of spacing, count and tolerance that was given; a tolerance may have a spacing beside it.
static process::ResampleResult resampled(const Context& context, const nlohmann::json& complete) {
    const surface::Surface& surface = context.document.surface();
    const auto tolerance = complete.at("tolerance").get<float>();
    const bool bySpacing = complete.contains("spacing"), byCount = complete.contains("count");
    if (byCount && (bySpacing || tolerance > 0))
        throw base::Error("\"count\" excludes \"spacing\" and \"tolerance\"", "resample", "give one of them");
    const process::Fit fit = complete.at("fit").get<bool>() ? process::Fit::On : process::Fit::Off;
    if (byCount)
        return process::resampleToCount(surface, complete.at("count").get<std::size_t>(), 12, context.progress, fit);
    if (!bySpacing && !(tolerance > 0))
        throw base::Error("\"resample\" needs a \"spacing\", a \"count\" or a \"tolerance\"", {}, "give one of them");
    const float spacing = bySpacing ? complete.at("spacing").get<float>() : process::typicalSpacing(surface.tree());
    if (const float size = surface.tree().bounds().diagonal(); spacing > size)
        throw base::Error("a spacing of " + base::shortNumber(static_cast<double>(spacing)) +
                              " is wider than the model, " + base::shortNumber(static_cast<double>(size)),
                          "resample", "choose one that is well below the size of the model");
    if (!(tolerance > 0))
        return process::resampleAll(surface, spacing, 12, context.progress, fit);
    const process::CurvatureSpacing by{tolerance, spacing * complete.at("finest").get<float>(),
                                       spacing * complete.at("coarsest").get<float>()};
    return process::resampleByCurvature(surface, by, 12, context.progress, fit);
}

static void resample(Context& context, const nlohmann::json& complete) {
    requireModel(context);
    if (context.document.surface().definition().manifold == surface::Manifold::Complex)
        throw base::Error("a complex cannot be resampled: its points belong to their cells", "resample",
                          "open it as a surface");
    process::ResampleResult result = resampled(context, complete);
    constexpr std::size_t least = 4; // as of opening
    if (const std::size_t left = result.surface.tree().size(); left < least)
        throw base::Error("a surface needs at least " + std::to_string(least) + " points, and that spacing leaves " +
                              std::to_string(left),
                          "resample", "choose one that is well below the size of the model");
    constexpr std::size_t few = 100; // shapes of so few points are hardly those that there were
    if (const std::size_t before = context.document.surface().tree().size(), left = result.surface.tree().size();
        left < few && left < before)
        context.messages.push_back(std::to_string(left) + " of " + std::to_string(before) +
                                   " points are left: that spacing is wide for this model");
    if (!result.settled)
        context.messages.push_back("resampling stopped after " + std::to_string(result.rounds) +
                                   " rounds, before the last points came to rest");
    // new points know the cell that they are of, but not yet how far off its creases are
    const base::Box3f bounds = result.surface.tree().bounds();
    const cells::EditedBall whole{bounds.centre(), bounds.diagonal() / 2};
    if (const tree::Edit labels = cells::measuredLabels(result.surface, {&whole, 1}); !labels.empty())
        result.surface = {result.surface.tree().apply(labels), result.surface.definition()};
    context.document.commit(std::move(result.surface), "Resample");
}

CommandRow resampleCommand() {
    static const CommandParameter parameters[] = {
        {"spacing", "number", "model units",
         "distance between neighbouring points to reach; with a tolerance alone: the median that there is", "null", "",
         positive, largest},
        {"count", "integer", "", "number of points to reach, within a few percent, instead of a spacing", "null", "", 4,
         largestCount},
        {"tolerance", "number", "model units",
         "above 0 the distance follows the curvature: the square root of tolerance over curvature, within the two "
         "limits; neighbouring distances differ by at most a tenth",
         "0", "", 0, largest},
        {"finest", "number", "spacings", "shortest distance, where it follows the curvature", "0.5", "", 0.01, 1},
        {"coarsest", "number", "spacings", "longest distance, where it follows the curvature", "2", "", 1, 100},
        {"fit", "boolean", "",
         "raise and tilt the new points until their surface is the one before, so that nothing wears off", "true", "",
         0, 0},
    };
    return {"resample", "Resample", "Spaces the points evenly on the surface that they define now.",
            parameters, true,       false,
            resample,   nullptr};
}

} // namespace session
