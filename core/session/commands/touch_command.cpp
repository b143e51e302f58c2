// touch: a simulated hand plays its way over the model and sculpts by what it feels. What is recorded are the strokes
// that come of it.
#include "core/base/error.h"
#include "core/haptics/devices/hand.h"
#include "core/session/commands/commands.h"
#include "core/session/json_text.h"
#include "core/session/option_json.h"
#include "core/session/stroke_json.h"
#include "core/session/touch_strokes.h"
#include "core/session/trajectory_file.h"

#include <nlohmann/json.hpp>

namespace session {

using base::Vec3d;
using nlohmann::json;

/// Longer ones would take hours and be no hand's way.
constexpr double mostSeconds = 3600;

static haptics::Trajectory inlineTrajectory(const json& rows) {
    haptics::Trajectory out;
    out.reserve(rows.size());
    for (const json& row : rows) {
        bool whole = row.is_array() && row.size() == 4;
        for (std::size_t k = 0; whole && k < 4; ++k)
            whole = row[k].is_number();
        if (!whole)
            throw base::Error("sample " + std::to_string(out.size() + 1) + " of \"touch\" is " + shortly(row, 200), {},
                              "a sample is [t,x,y,z]: seconds, ascending, and a place");
        out.push_back({row[0].get<double>(), {row[1].get<double>(), row[2].get<double>(), row[3].get<double>()}});
    }
    return out;
}

/// In the model's stored coordinates.
static haptics::Trajectory wayOf(const Context& context, const json& complete) {
    if (complete.contains("trajectory") == complete.contains("samples"))
        throw base::Error("\"touch\" needs either \"trajectory\" or \"samples\"", {},
                          "a file with the header t,x,y,z, or a list of [t,x,y,z]");
    haptics::Trajectory out =
        complete.contains("samples")
            ? inlineTrajectory(complete["samples"])
            : readTrajectory(io::FileBytes(complete["trajectory"].get<std::string>()), context.progress);
    for (haptics::TimedPlace& each : out)
        each.place -= context.document.provenance().origin;
    haptics::requireValid(out);
    if (out.back().time - out.front().time > mostSeconds)
        throw base::Error("the way of \"touch\" lasts longer than an hour", {},
                          "part it, or check that t is in seconds");
    return out;
}

static haptics::ServoOptions servoOptions(const Context& context, const json& complete,
                                          const sculpt::StrokeSettings& settings, const Vec3d& begin) {
    const auto number = [&](const char* id) { return complete.at(id).get<double>(); };
    const base::Box3f bounds = context.document.surface().tree().bounds();
    haptics::ServoOptions out;
    out.tool = {number("tip"), number("friction")};
    out.law.stiffness = number("stiffness");
    out.law.damping = number("damping");
    out.law.texture = {number("relief"), number("grain")};
    haptics::TouchLaw law;
    law.threshold = number("threshold");
    law.full = std::max(number("full"), law.threshold);
    law.viscosity = number("viscosity");
    law.tear = number("tear");
    out.touch = touchLawOf(settings, law);
    out.safety = haptics::SafetyLimits::off(); // nobody can be hurt, and nothing is late in its own time
    out.mostSteps = haptics::Proxy::patient;
    out.port.mass = haptics::HandModel{}.mass;
    out.port.tick = haptics::HandModel{}.tick;
    out.workspace.centre = begin;
    out.workspace.scale = complete.contains("scale") ? number("scale") : haptics::viewedScale(bounds);
    return out;
}

static void touch(Context& context, const json& complete) {
    requireModel(context);
    const sculpt::StrokeSettings settings = strokeSettings(complete);
    haptics::Trajectory way = wayOf(context, complete);
    const haptics::ServoOptions options = servoOptions(context, complete, settings, way.front().place);
    const double begin = way.front().time, seconds = way.back().time - begin;
    for (haptics::TimedPlace& each : way)
        each = {each.time - begin, options.workspace.position(each.place)};

    TouchStrokes strokes(context, settings);
    haptics::Servo servo(options);
    const auto hand = haptics::makeHand(way, {});
    const auto patchOf = [](const surface::Surface& surface) {
        return std::make_shared<const haptics::Patch>(haptics::Patch{surface, 0, surface.tree().bounds()});
    };
    haptics::PatchPtr patch = patchOf(strokes.surface());
    haptics::DeviceState state;
    std::uint64_t begun = 0;
    double most = 0;
    while (hand->read(state)) {
        context.progress.step(seconds > 0 ? state.time / seconds : 1, "Touching");
        const haptics::Tick tick = servo.step(patch, state, {state.time, 0, state.time, true});
        hand->send(tick.sent);
        begun = tick.touched.stroke;
        most = std::max(most, length(tick.sent));
        if (strokes.step(tick))
            patch = patchOf(strokes.surface());
    }
    strokes.end();
    context.instead = std::make_shared<json>(strokes.lines());
    context.figures["strokes"] = static_cast<double>(strokes.lines().size());
    context.figures["most_force"] = most;
    if (strokes.lines().empty())
        context.messages.push_back(begun > 0 ? "the hand pressed on the model and changed nothing"
                                             : "the hand never pressed beyond the threshold: it only felt");
}

/// What the table does not name must be the tool's own.
static void checkToolParameter(const json& command, const std::string& key, const json& value) {
    json stroke{{"op", "stroke"}, {"tool", command.at("tool")}};
    session::command("stroke").checkFurther(stroke, key, value);
}

static std::vector<CommandParameter> touchParameters() {
    std::vector<CommandParameter> out;
    for (const CommandParameter& each : session::strokeParameters())
        if (each.id != std::string_view("samples"))
            out.push_back(each);
    const CommandParameter own[] = {
        {"trajectory", "path", "", "text file with the header t,x,y,z: where the hand wants to be, and when", "null",
         "", 0, 0},
        {"samples", "list", "", "the same in place of a file: [t,x,y,z], in seconds and model units", "null", "", 0, 0},
        {"tip", "number", "model units", "radius of the ball that touches; 0: a point", "0", "", 0, largest},
        {"stiffness", "number", "N/m", "of the clay under the tip", "1000", "", positive, 3000},
        {"friction", "number", "", "of the tip on the clay: tangential over normal force", "0", "", 0, 100},
        {"damping", "number", "N s/m", "along the normal, in contact", "0", "", 0, 20},
        {"relief", "number", "", "texture: part of the stiffness that comes and goes with how the surface stands out",
         "0", "", 0, 1},
        {"grain", "number", "", "the same with how light it is", "0", "", 0, 1},
        {"viscosity", "number", "N s/m", "of the clay while it is worked or pulled", "2", "", 0, 20},
        {"threshold", "number", "N", "pressing more than this makes the tool work", "0.5", "", positive, 100},
        {"full", "number", "N", "the force of pressure 1", "3", "", positive, 100},
        {"tear", "number", "N", "a pull of more than this tears what is held off the tool", "8", "", positive, 1000},
        {"scale", "number", "model units per metre", "of the hand's ways; by default the model is as large as 20 cm",
         "null", "", positive, largest},
    };
    out.insert(out.end(), std::begin(own), std::end(own));
    return out;
}

CommandRow touchCommand() {
    static const auto parameters = touchParameters();
    return {"touch",
            "Touch",
            "Sculpts by the force of a simulated hand that goes along a way.",
            parameters,
            true,
            false,
            touch,
            checkToolParameter,
            HiddenParts::Spared};
}

} // namespace session
