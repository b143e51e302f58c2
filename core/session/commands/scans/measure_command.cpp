#include "core/base/error.h"
#include "core/process/estimation/part_progress.h"
#include "core/session/commands/commands.h"
#include "core/session/commands/other_model.h"
#include "core/session/commands/scans/clean_steps.h"
#include "core/session/measured_model.h"
#include "core/session/number_lists.h"
#include "core/surface/definition_text.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

static void measureDeviation(Context& context, const json& complete, MeasuredModel& out) {
    const auto path = complete.at("to").get<std::string>();
    const Document other = otherModel(context, complete, 0, process::part(context.progress, 0, 0.3));
    json pinned = complete;
    pinned["hash"] = other.hash().text();
    context.instead = std::make_shared<json>(json::array({std::move(pinned)}));
    if (other.surface().definition().manifold != surface::Manifold::Surface)
        throw base::Error("distances to " + surface::nounOf(other.surface().definition().manifold) + " are not told",
                          path, "use --manifold surface");
    const Document& own = context.document;
    out.deviation = process::deviationsOf(own.surface().tree(), other.surface(),
                                          own.provenance().origin - other.provenance().origin,
                                          process::part(context.progress, 0.3, 0.7));
    const process::DeviationFigures& found = out.deviation->figures;
    if (found.count == 0)
        throw base::Error("no surfel has a foot on that surface", path,
                          "check that both models are in one place and of one size");
    context.messages.push_back("Deviation: " + sentenceOf(found) + ".");
    for (const auto& [name, value] :
         {std::pair{"rms", found.rms}, {"mean", found.mean}, {"p99", found.p99}, {"max", found.max}})
        context.figures[name] = value;
}

static void measure(Context& context, const json& complete) {
    requireModel(context);
    const surface::Surface now = context.document.surface();
    if (now.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(now.definition().manifold) +
                              " has no thickness, and no distances from it are told",
                          {}, "use it on surfaces");
    MeasuredModel found;
    if (complete.contains("to"))
        measureDeviation(context, complete, found);
    if (complete.at("thickness").get<bool>()) {
        found.thickness = process::thicknessesOf(now, process::part(context.progress, 0.7, 1));
        context.messages.push_back("Thickness: " + sentenceOf(found.thickness->figures) + ".");
        context.figures["thickness"] = found.thickness->figures.median;
    }
    if (!found.deviation && !found.thickness)
        throw base::Error("nothing to measure", {}, "name \"to\" or \"thickness\"");
    found.colours = complete.value("colours", "");
    if (complete.contains("range")) {
        if (found.colours.empty())
            throw base::Error("\"range\" is what colours span", {}, "name \"colours\", too");
        const std::vector<double> ends = numbersOf(complete, "range", 2, "[low,high]");
        found.range = {ends[0], ends[1]};
    }
    clean::commit(context, withMeasured(now, found), "Measure");
}

CommandRow measureCommand() {
    static const CommandParameter parameters[] = {
        {"to", "path", "",
         "another model: how far each point is from its surface, > 0 on the side of its normals, goes into the "
         "attribute \"deviation\"",
         "null", "", 0, 0},
        {"thickness", "boolean", "",
         "how thick the model is under each point, straight inwards, goes into the attribute \"thickness\"", "false",
         "", 0, 0},
        {"colours", "choice", "", "colour the points by one of them", "null", measuredNames, 0, 0},
        {"range", "list", "model units", "[low,high] that the colours span; most of the numbers unless told", "null",
         "", 0, 0},
        {"hash", "text", "", "content hash that the other model must have", "null", "", 0, 0, true},
        sourcesParameter(),
    };
    return {"measure",
            "Measure",
            "Measures at every point: its distance to another model, or how thick the model is there.",
            parameters,
            true,
            false,
            measure,
            nullptr};
}

} // namespace session
