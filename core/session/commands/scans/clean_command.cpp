#include "core/base/error.h"
#include "core/process/cleaning/mixed_pixels.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static json given(const json& complete, const char* id) {
    return complete.value(id, json());
}

/// By one way after the other, each looking at what the ones before it left.
static surface::Surface withoutOutliers(Context& context, surface::Surface surface, const json& complete) {
    const json& wish = complete.at("outliers");
    const json ways = wish.is_array() ? wish : json::array({wish});
    if (ways.size() > 1 && complete.contains("limit"))
        throw base::Error("\"limit\" means something else to each way of finding outliers", {},
                          "give one way, or several without a limit");
    double all = 0;
    for (const json& way : ways) {
        surface = clean::outliers(context, surface, way.get<std::string>(), given(complete, "limit"));
        all += context.figures.at("outliers");
        context.figures["outliers_" + way.get<std::string>()] = context.figures.at("outliers");
    }
    context.figures["outliers"] = all;
    return surface;
}

/// In the order in which each step helps the next one: strays first, then noise, then what is made of positions.
static void runClean(Context& context, const json& complete) {
    requireModel(context);
    const std::vector<const char*> steps{"duplicates", "mixed", "outliers", "denoise", "thin", "normals", "orient"};
    const auto wanted = [&](const char* step) {
        const json value = given(complete, step);
        return !value.is_null() && !(value.is_boolean() && !value.get<bool>());
    };
    if (std::none_of(steps.begin(), steps.end(), wanted))
        throw base::Error("nothing to do", {},
                          "name at least one of duplicates, mixed, outliers, denoise, thin, normals, orient");
    surface::Surface surface = context.document.surface();
    const json viewpoint = given(complete, "viewpoint");
    if (wanted("duplicates"))
        surface = clean::duplicates(context, surface);
    if (wanted("mixed"))
        surface = clean::mixed(context, surface, viewpoint, process::MixedQuestion().limit);
    if (wanted("outliers"))
        surface = withoutOutliers(context, surface, complete);
    if ((wanted("outliers") || wanted("mixed")) && !wanted("normals") && !wanted("orient"))
        surface = clean::guessedAgain(context, surface, viewpoint);
    if (wanted("denoise"))
        surface = clean::denoise(context, surface, complete.at("denoise"));
    if (wanted("thin"))
        surface = clean::thin(context, surface, complete.at("thin").get<float>());
    if (wanted("normals"))
        surface = clean::normals(context, surface, complete.at("normals").get<std::string>(), viewpoint);
    if (wanted("orient"))
        surface = clean::orient(context, surface, complete.at("orient").get<std::string>(), viewpoint);
    clean::commit(context, std::move(surface), "Clean", layers::How::Keep);
}

CommandRow cleanCommand() {
    static const CommandParameter parameters[] = {
        {"duplicates", "boolean", "", "merge points that stand in one place", "false", "", 0, 0},
        {"mixed", "boolean", "", "take out mixed pixels: half on the near, half on the far side of an edge in depth",
         "false", "", 0, 0},
        {"outliers", "choices", "", clean::outlierTip, "null", clean::outlierWays, 0, 0},
        {"limit", "number", "", clean::limitTip, "null", "", 0, largest},
        {"denoise", "number or choice", "model units", clean::sigmaTip, "null", "auto", positive, largest},
        {"thin", "number", "model units", clean::spacingTip, "null", "", positive, largest},
        {"normals", "choice", "", clean::normalTip, "null", clean::normalWays, 0, 0},
        {"orient", "choice", "", clean::orientTip, "null", clean::orientWays, 0, 0},
        {"viewpoint", "list", "model units", clean::viewpointTip, "null", "", 0, 0},
    };
    return {"clean",
            "Clean",
            "Takes out of a scan what is not the model, in this order: duplicates, mixed pixels, outliers, noise; "
            "thins it, and makes its normals anew.",
            parameters,
            true,
            false,
            runClean,
            nullptr};
}

} // namespace session
