#include "core/base/error.h"
#include "core/session/commands/commands.h"
#include "core/session/json_text.h"
#include "core/session/live_stroke.h"
#include "core/session/option_json.h"
#include "core/session/stroke_json.h"

#include <nlohmann/json.hpp>

namespace session {

using nlohmann::json;

/// The same hands as the window's, without a journal: the executor writes the line.
static void stroke(Context& context, const json& complete) {
    const auto samples = strokeSamples(complete, context.document.provenance().origin);
    if (samples.empty())
        throw base::Error("the stroke has no samples");
    Context quiet{context.document, context.folder, context.progress, {}, 0, {}, nullptr};
    const sculpt::StrokeSettings settings = strokeSettings(complete);
    LiveStroke live(quiet, settings);
    const bool jumps = sculpt::lastOnly(settings); // what lies between has no say, and is not tried
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (jumps && i > 0 && i + 1 < samples.size())
            continue;
        context.progress.step(static_cast<double>(i) / static_cast<double>(samples.size()), "Stroke");
        live.add(samples[i]);
    }
    if (!live.finish())
        context.messages.push_back("a stroke of " + std::to_string(samples.size()) +
                                   (samples.size() == 1 ? " sample " : " samples ") +
                                   (live.depth() ? "met the model and changed nothing" : "missed the model"));
    context.messages.insert(context.messages.end(), quiet.messages.begin(), quiet.messages.end());
    context.dabs += quiet.dabs;
    context.dabSeconds.insert(context.dabSeconds.end(), quiet.dabSeconds.begin(), quiet.dabSeconds.end());
}

/// What the table does not name must be the tool's own.
static void checkToolParameter(const json& command, const std::string& key, const json& value) {
    sculpt::StrokeSettings settings;
    settings.tool = command.at("tool").get<std::string>();
    settings.radius = 1;
    if (!value.is_number())
        throw base::Error("\"" + key + "\" of \"stroke\" is " + shortly(value), {},
                          "a tool's own parameters are numbers");
    settings.parameters[key] = value.get<double>();
    sculpt::check(settings);
}

std::vector<CommandParameter> strokeParameters() {
    static const std::string tools = idsOf(sculpt::toolTable());
    std::vector<CommandParameter> out{{"tool", "choice", "",
                                       "what each dab does; the tool's own parameters may be given beside it", "",
                                       tools.c_str(), 0, 0}};
    for (const sculpt::StrokeOption& option : sculpt::strokeOptionTable())
        out.push_back(parameterOf(option));
    out.push_back(
        {"samples", "list", "",
         "rays with pressure and time: [ox,oy,oz,dx,dy,dz,pressure,seconds]; an optional ninth number, for merged "
         "input, multiplies the spacing and strength of the dabs on the way to the sample; a tenth, for pointers that "
         "have a place in space, is how far along its ray that is",
         "", "", 0, 0});
    return out;
}

CommandRow strokeCommand() {
    static const auto parameters = strokeParameters();
    return {"stroke",           "Stroke",           "Sculpts along a path of rays.", parameters, true, false, stroke,
            checkToolParameter, HiddenParts::Spared};
}

} // namespace session
