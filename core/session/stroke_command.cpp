#include "core/base/error.h"
#include "core/session/commands.h"
#include "core/session/live_stroke.h"
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
    LiveStroke live(quiet, strokeSettings(complete));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        context.progress.step(static_cast<double>(i) / static_cast<double>(samples.size()), "Stroke");
        live.add(samples[i]);
    }
    if (!live.finish())
        context.messages.push_back("a stroke of " + std::to_string(samples.size()) + " samples did not meet the model");
    context.dabs += quiet.dabs;
    context.dabSeconds.insert(context.dabSeconds.end(), quiet.dabSeconds.begin(), quiet.dabSeconds.end());
}

/// What the table does not name must be the tool's own.
static void checkToolParameter(const json& command, const std::string& key, const json& value) {
    sculpt::StrokeSettings settings;
    settings.tool = command.at("tool").get<std::string>();
    settings.radius = 1;
    if (!value.is_number())
        throw base::Error("\"" + key + "\" of \"stroke\" is " + value.dump(), {},
                          "a tool's own parameters are numbers");
    settings.parameters[key] = value.get<double>();
    sculpt::check(settings);
}

CommandRow strokeCommand() {
    static const std::string tools = idsOf(sculpt::toolTable()), falloffs = idsOf(sculpt::falloffTable()),
                             methods = idsOf(sculpt::methodTable());
    static const CommandParameter parameters[] = {
        {"tool", "choice", "", "what each dab does; the tool's own parameters may stand beside it", "", tools.c_str(),
         0, 0},
        {"radius", "number", "model units", "of the brush", "", "", positive, largest},
        {"strength", "number", "", "how much each dab does; each tool has its own default", "null", "", 0, 1},
        {"invert", "boolean", "", "does the opposite: push in, carve", "false", "", 0, 0},
        {"falloff", "choice", "", "how a dab fades from its centre to its rim", "\"smooth\"", falloffs.c_str(), 0, 0},
        {"symmetry", "list", "", "axes across which the stroke is mirrored: \"x\", \"y\", \"z\"", "[]", "", 0, 0},
        {"resample", "boolean", "", "lets the sampling follow the deformation", "true", "", 0, 0},
        {"graded", "boolean", "",
         "resamples to the spacing that the points have at each place, as \"resample\" by curvature left it; false: to "
         "that of the stroke's first contact",
         "false", "", 0, 0},
        {"spacing", "number", "radii", "distance of dabs along the stroke", "0.1", "", 0.005, 10},
        {"method", "choice", "",
         "how samples become dabs: evenly along the surface, one each, evenly in time, one that is drawn large, evenly "
         "on a straight line; tools that hold what they touched first take no notice",
         "\"space\"", methods.c_str(), 0, 0},
        {"rate", "number", "dabs a second", "of the method airbrush", "20", "", 1, 500},
        {"stabiliser", "number", "radii", "length of the rope on which the brush follows the pointer; 0: none", "0", "",
         0, 100},
        {"pressure-strength", "list", "", "curve of the strength over the pressure: 2 to 16 points [x,y], 0 to 1",
         "[[0,0],[1,1]]", "", 0, 0},
        {"pressure-radius", "list", "", "curve of the radius over the pressure, as a part of it", "[[0,1],[1,1]]", "",
         0, 0},
        {"falloff-curve", "list", "", "of the falloff custom: weight over distance in radii", "[[0,1],[1,0]]", "", 0,
         0},
        {"radial", "integer", "", "copies of the stroke, turned evenly about an axis, beside its mirror images", "1",
         "", 1, 64},
        {"radial-axis", "choice", "", "that they are turned about, through the origin", "\"z\"", "x y z", 0, 0},
        {"accumulate", "boolean", "",
         "dabs build on each other; false: on the surface that the stroke began on, so that they do not pile up",
         "true", "", 0, 0},
        {"auto-smooth", "number", "", "strength of the tool smooth after every dab", "0", "", 0, 1},
        {"front-facing", "boolean", "", "leaves alone what faces away from the viewer", "false", "", 0, 0},
        {"connected", "boolean", "", "works only on what can be reached along the surface within the brush", "false",
         "", 0, 0},
        {"normal-radius", "number", "radii", "area whose mean normal is the direction of tools that have one", "0.5",
         "", 0, 2},
        {"plane-radius", "number", "radii", "area whose mean position is the place of tools' planes", "0.5", "", 0, 2},
        {"stamp", "path", "", "grey image (PNG, JPEG) that the brush presses in: white fully, black not at all", "null",
         "", 0, 0},
        {"stamp-angle", "number", "degrees", "turns the stamp to the left", "0", "", -360, 360},
        {"stamp-follows", "boolean", "",
         "the stamp's upper edge leads along the stroke; false: it stands upright as seen", "false", "", 0, 0},
        {"samples", "list", "",
         "rays with pressure and time: [ox,oy,oz,dx,dy,dz,pressure,seconds]; a ninth number multiplies the dabs' "
         "distance and strength on the way to it, where input was merged",
         "", "", 0, 0},
    };
    return {"stroke", "Stroke", "Sculpts along a line of rays.", parameters, true, false, stroke, checkToolParameter};
}

} // namespace session
