#include "core/sculpt/stroke_options.h"

#include "core/base/row_of_id.h"

#include <numbers>

namespace sculpt {

constexpr OptionGroupRow groups[] = {
    {OptionGroup::Brush, "brush", "Brush", true},           {OptionGroup::Falloff, "falloff", "Falloff", true},
    {OptionGroup::Stroke, "stroke", "Stroke", true},        {OptionGroup::Area, "area", "Area", false},
    {OptionGroup::Pressure, "pressure", "Pressure", false}, {OptionGroup::Stamp, "stamp", "Stamp", false},
};

std::span<const OptionGroupRow> optionGroupTable() {
    return groups;
}

static bool has(const ToolRow& tool, std::string_view id) {
    return base::findRow(tool.parameters, id) != nullptr;
}

bool hasSource(const ToolRow& tool) {
    return has(tool, "x") && has(tool, "y") && has(tool, "z");
}

// --- which tools an option has a say with ---

static bool always(const ToolRow&, const StrokeSettings&) {
    return true;
}
/// Those that make dabs along the stroke, and hold nothing.
static bool dabs(const ToolRow& tool, const StrokeSettings&) {
    return !holds(tool);
}
static bool pilesUp(const ToolRow& tool, const StrokeSettings&) {
    return tool.motion == Motion::Along;
}
static bool shapes(const ToolRow& tool, const StrokeSettings&) {
    return tool.writes == Writes::Shape || tool.writes == Writes::Surface;
}
static bool spaced(const ToolRow& tool, const StrokeSettings& settings) {
    return dabs(tool, settings) && (settings.method == StrokeMethod::Space || settings.method == StrokeMethod::Line);
}
static bool timed(const ToolRow& tool, const StrokeSettings& settings) {
    return dabs(tool, settings) && settings.method == StrokeMethod::Airbrush;
}
static bool follows(const ToolRow&, const StrokeSettings& settings) {
    return !lastOnly(settings);
}
static bool stamped(const ToolRow&, const StrokeSettings& settings) {
    return !settings.stamp.empty();
}
static bool onPlane(const ToolRow& tool, const StrokeSettings&) {
    return has(tool, "offset");
}

std::span<const StrokeOption> strokeOptionTable() {
    using enum OptionGroup;
    using S = StrokeSettings;
    static const StrokeOption rows[] = {
        {"strength", "Strength", "",
         "How much one dab does; the pressure of a pen multiplies it. Hold Shift+F and move.", Brush, &S::strength,
         always},
        {"auto-smooth", "Auto-smooth", "", "Strength of the smooth tool after every dab.", Brush, &S::autoSmooth,
         shapes},
        {"invert", "Invert", "", "The tool's opposite; Ctrl does it while held.", Brush, &S::invert, always},
        {"accumulate", "Accumulate", "",
         "Dabs build on each other. Off: they work on the surface that the stroke began on, and do not pile up.", Brush,
         &S::accumulate, pilesUp},
        {"falloff", "Falloff", "", "How a dab fades from its centre to its rim.", Falloff, &S::falloff, always},
        {"falloff-curve", "Falloff curve", "",
         "Weight from the brush's centre (left) to its rim (right). Click for a point, drag it, right-click removes "
         "it.",
         Falloff, &S::falloffCurve, always},
        {"method", "Method", "", "How the pointer's way becomes dabs.", Stroke, &S::method, dabs},
        {"spacing",
         "Spacing",
         "radii",
         "Distance of dabs along the stroke.",
         Stroke,
         &S::spacing,
         spaced,
         {0.005, 10, 0.01, 1, true, 1}},
        {"rate",
         "Rate",
         "per s",
         "Dabs a second, also while the pointer rests.",
         Stroke,
         &S::rate,
         timed,
         {1, 500, 1, 100, true, 1}},
        {"stabiliser",
         "Stabiliser",
         "radii",
         "The brush follows the pointer on a rope of this length, so that a trembling hand draws a smooth line.",
         Stroke,
         &S::stabiliser,
         follows,
         {0, 100, 0, 3, false, 1}},
        {"front-facing", "Front faces", "", "Leaves alone what faces away from you.", Area, &S::frontFacing, always},
        {"connected", "Connected", "",
         "Works only on what can be reached along the surface, not on the other side of a thin sheet.", Area,
         &S::connected, always},
        {"normal-radius",
         "Normal from",
         "radii",
         "Area whose mean normal is the direction of tools that have one.",
         Area,
         &S::normalRadius,
         shapes,
         {0, 2, 0, 2, false, 1}},
        {"plane-radius",
         "Plane from",
         "radii",
         "Area whose mean position is the place of the tool's plane.",
         Area,
         &S::planeRadius,
         onPlane,
         {0, 2, 0, 2, false, 1}},
        {"pressure-strength", "Strength", "",
         "Strength over the pressure of the pen, from none (left) to full (right).", Pressure, &S::pressureStrength,
         dabs},
        {"pressure-radius", "Radius", "", "Radius over the pressure of the pen, as a part of it.", Pressure,
         &S::pressureRadius, dabs},
        {"stamp", "Stamp", "", "Grey image that the brush presses in: white works fully, black not at all.", Stamp,
         &S::stamp, always},
        {"stamp-angle",
         "Angle",
         "°",
         "Turns the stamp to the left.",
         Stamp,
         &S::stampAngleRad,
         stamped,
         {-5000, 5000, -180, 180, false, 180 / std::numbers::pi}},
        {"stamp-follows", "Follow the stroke", "",
         "The stamp's upper edge leads along the stroke; off: it stands upright as seen.", Stamp, &S::stampFollows,
         stamped},
    };
    return rows;
}

StrokeSettings defaultsOf(const ToolRow& tool) {
    StrokeSettings out;
    out.tool = tool.id;
    out.strength = static_cast<float>(tool.strength);
    for (const ToolParameter& parameter : tool.parameters)
        out.parameters[parameter.id] = parameter.fallback;
    return out;
}

} // namespace sculpt
