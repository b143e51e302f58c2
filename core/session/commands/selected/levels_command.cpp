#include "core/base/error.h"
#include "core/selection/hidden.h"
#include "core/selection/levels.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/number_lists.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;
using selection::Levels, selection::Limit;

static base::Vec3d gainsOf(const Context& context, const json& complete, Limit limit) {
    const tree::SurfelTree& tree = context.document.surface().tree();
    if (const auto grey = placeOf(context, complete, "grey"))
        return selection::greyGains(selection::meanLightAt(tree, *grey));
    if (complete.at("balance").get<bool>())
        return selection::greyGains(selection::meanLight(tree, limit));
    return {1, 1, 1};
}

static void levels(Context& context, const json& complete) {
    requireModel(context);
    const tree::SurfelTree& now = context.document.surface().tree();
    if (!now.layout()->colours)
        throw base::Error("the model has no colours", {}, "paint it, or fill it with \"colour\"");
    const Limit limit = limitOf(context, complete);
    Levels wanted;
    wanted.gain = gainsOf(context, complete, limit);
    const auto [low, high] = selection::usedRange(now, limit, wanted.gain);
    const auto level = [&](const char* name, double own) {
        return complete.at(name).is_string() ? own : complete.at(name).get<double>();
    };
    wanted.black = level("black", low), wanted.white = level("white", high);
    wanted.gamma = complete.at("gamma").get<double>();
    if (!(wanted.black < wanted.white))
        throw base::Error("black must be below white", "levels", "give a lower black or a higher white");
    const auto hundredth = [](double v) { return std::round(100 * v) / 100; };
    std::ostringstream told;
    told << "Levels from " << wanted.black << " to " << wanted.white << "; red " << hundredth(wanted.gain.x)
         << ", green " << hundredth(wanted.gain.y) << " and blue " << hundredth(wanted.gain.z)
         << " times as bright for the balance.";
    context.messages.push_back(told.str());
    const tree::SurfelTree next = selection::levelled(now, wanted, limit);
    clean::commit(context, {selection::hiddenSpared(now, next), context.document.surface().definition()}, "Levels");
}

CommandRow levelsCommand() {
    static const CommandParameter parameters[] = {
        {"black", "number or choice", "", "level that becomes black; auto: half a percent are darker", "0", "auto", 0,
         254},
        {"white", "number or choice", "", "level that becomes white; auto: half a percent are brighter", "255", "auto",
         1, 255},
        {"gamma", "number", "", "above 1 makes middle tones brighter, below 1 darker", "1", "", 0.1, 10},
        {"balance", "boolean", "", "takes out a cast: what is changed becomes grey in the mean", "false", "", 0, 0},
        {"grey", "list", "model units", "[x,y,z]: what stands there becomes grey, in place of the mean", "null", "", 0,
         0},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"levels",   "Levels", "Brightness, contrast and white balance of colours.",
            parameters, true,     false,
            levels,     nullptr,  HiddenParts::Spared};
}

} // namespace session
