#include "core/process/estimation/part_progress.h"
#include "core/selection/shape.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/commands/selected/limits.h"
#include "core/session/commands/selected/opposite_sides.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static void blend(Context& context, const json& complete, double sign, const char* label) {
    requireModel(context);
    requireSurface(context);
    clean::commit(context,
                  selection::smoothed(context.document.surface(), complete.at("scale").get<double>(),
                                      sign * complete.at("strength").get<double>(), limitOf(context, complete),
                                      context.progress),
                  label, layers::How::Record);
}

static void smooth(Context& context, const json& complete) {
    blend(context, complete, 1, "Smooth");
}

static void sharpen(Context& context, const json& complete) {
    blend(context, complete, -1, "Sharpen");
}

constexpr const char* scaleTip = "how many times as wide as the points' supports: detail smaller than this is meant";

CommandRow smoothCommand() {
    static const CommandParameter parameters[] = {
        {"scale", "number", "h", scaleTip, "2", "", 1, 16},
        {"strength", "number", "", "part of the way to the smooth surface", "1", "", 0, 1},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {
        "smooth",   "Smooth", "Moves points onto the surface of wider supports, without shrinking; masked ones stay.",
        parameters, true,     false,
        smooth,     nullptr,  HiddenParts::Spared};
}

CommandRow sharpenCommand() {
    static const CommandParameter parameters[] = {
        {"scale", "number", "h", scaleTip, "2", "", 1, 16},
        {"strength", "number", "", "1 doubles what stands out of the smooth surface", "0.5", "", 0, 4},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"sharpen",
            "Sharpen",
            "Moves points away from the surface of wider supports: relief stands out more; masked ones stay.",
            parameters,
            true,
            false,
            sharpen,
            nullptr,
            HiddenParts::Spared};
}

static void inflate(Context& context, const json& complete) {
    requireModel(context);
    requireSurface(context);
    const double length = complete.at("length").get<double>();
    const auto height = [length](const base::Vec3d&) { return selection::Height{length, {}}; };
    surface::Surface next = selection::raised(context.document.surface(), height, limitOf(context, complete),
                                              process::part(context.progress, 0, length < 0 ? 0.5 : 1));
    if (length < 0)
        requireApart(context, next.tree());
    clean::commit(context, std::move(next), "Inflate", layers::How::Record);
}

CommandRow inflateCommand() {
    static const CommandParameter parameters[] = {
        {"length", "number", "model units", "how far outwards; below 0 inwards, until sides meet", "", "", -largest,
         largest},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"inflate",  "Inflate", "Moves the surface along its normals by a length; masked points stay.",
            parameters, true,      false,
            inflate,    nullptr,   HiddenParts::Spared};
}

static void roughen(Context& context, const json& complete) {
    requireModel(context);
    requireSurface(context);
    const double amplitude = complete.at("amplitude").get<double>(), size = complete.at("size").get<double>();
    const auto seed = complete.at("seed").get<std::uint64_t>();
    const auto height = [=](const base::Vec3d& x) {
        const selection::Height out = selection::noiseAt(x, size, seed);
        return selection::Height{amplitude * out.value, out.slope * amplitude};
    };
    clean::commit(context,
                  selection::raised(context.document.surface(), height, limitOf(context, complete), context.progress),
                  "Noise", layers::How::Record);
}

CommandRow noiseCommand() {
    static const CommandParameter parameters[] = {
        {"amplitude", "number", "model units", "most that the surface is raised or lowered by", "", "", 0, largest},
        {"size", "number", "model units", "width of bumps", "", "", positive, largest},
        {"seed", "integer", "", "another number, another noise", "1", "", 0, 4294967295.0},
        {"of", "choice", "", limitTip, limitFallback, limits, 0, 0},
    };
    return {"noise",    "Noise", "Raises and lowers the surface by smooth noise; masked points stay.",
            parameters, true,    false,
            roughen,    nullptr, HiddenParts::Spared};
}

} // namespace session
