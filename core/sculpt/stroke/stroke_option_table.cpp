// The rows of the options of a stroke, and with which tools each has a say.
#include "core/sculpt/stroke/stroke_options.h"

namespace sculpt {

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
    return movesSurfaces(tool);
}
static bool spaced(const ToolRow& tool, const StrokeSettings& settings) {
    return dabs(tool, settings) && (settings.method == StrokeMethod::Space || settings.method == StrokeMethod::Line);
}
static bool tapped(const ToolRow& tool, const StrokeSettings& settings) {
    return spaced(tool, settings) || (dabs(tool, settings) && settings.method == StrokeMethod::Anchored);
}
static bool timed(const ToolRow& tool, const StrokeSettings& settings) {
    return dabs(tool, settings) && settings.method == StrokeMethod::Airbrush;
}
static bool follows(const ToolRow&, const StrokeSettings& settings) {
    return !lastOnly(settings);
}
static bool turned(const ToolRow&, const StrokeSettings& settings) {
    return settings.symmetry.copies > 1;
}
static bool stamped(const ToolRow&, const StrokeSettings& settings) {
    return !settings.stamp.empty();
}
static bool drawsLines(const ToolRow& tool, const StrokeSettings&) {
    const std::string_view id = tool.id;
    return id == "crease" || id == "pinch" || id == "draw-sharp";
}
static bool smooths(const ToolRow& tool, const StrokeSettings&) {
    return std::string_view(tool.id) == "smooth";
}
static bool onPlane(const ToolRow& tool, const StrokeSettings&) {
    return tool.needs.plane;
}

std::span<const StrokeOption> strokeOptionTable() {
    using enum OptionGroup;
    using S = StrokeSettings;
    using R = OptionRange;
    static const StrokeOption rows[] = {
        {"radius",
         "Radius",
         "model units",
         "Radius of the brush.",
         "",
         Brush,
         &S::radius,
         always,
         {R::aboveZero, R::largest},
         Scope::Stroke,
         Fallback::None},
        {"strength",
         "Strength",
         "",
         "How much each dab does; each tool has its own default.",
         "The pressure of a pen multiplies it. Hold Shift+F and move.",
         Brush,
         &S::strength,
         always,
         {},
         Scope::Tool,
         Fallback::Tool},
        {"auto-smooth", "Auto-smooth", "", "Strength of smoothing after every dab.", "", Brush, &S::autoSmooth, shapes},
        {"invert", "Invert", "", "Does the opposite: pushes in, carves.", "Ctrl does it while held.", Brush, &S::invert,
         always},
        {"accumulate", "Accumulate", "",
         "Dabs build on each other; off: they work on the surface as the stroke found it, and do not pile up.", "",
         Brush, &S::accumulate, pilesUp},
        {"resample",
         "Resample",
         "",
         "Lets the sampling follow the deformation: gaps fill, crowds merge.",
         "With every tool.",
         Brush,
         &S::resample,
         always,
         {},
         Scope::AllTools},
        {"graded",
         "Graded",
         "",
         "Evens out all that the stroke touches, to the spacing that the supports at each place are made for; off: "
         "keeps the existing sampling, and mends what the stroke stretches or squeezes.",
         "",
         Brush,
         &S::graded,
         always,
         {},
         Scope::Stroke},
        {"edge", "Edge", "",
         "How sharp an edge the stroke leaves along its way, one that later strokes keep; 0: none, the line is as "
         "round "
         "as points make it.",
         "", Brush, &S::edge, drawsLines},
        {"fade-edges", "Fade edges", "",
         "Edges that stay sharp give way under the brush, by its strength and falloff; off: they are kept.", "", Brush,
         &S::fadeEdges, smooths},
        {"falloff", "Falloff", "", "How a dab fades from its centre to its rim.", "", Falloff, &S::falloff, always},
        {"falloff-curve", "Falloff curve", "", "For the falloff custom: weight over distance in radii.",
         "Click to add a point, drag to move it, right-click to remove it.", Falloff, &S::falloffCurve, always},
        {"method", "Method", "",
         "How samples become dabs: evenly along the surface, one each, evenly in time, one sized by dragging, evenly "
         "along a straight line; ignored by tools that hold what they touched first.",
         "", Stroke, &S::method, dabs},
        {"spacing",
         "Spacing",
         "radii",
         "Distance between dabs along the stroke.",
         "",
         Stroke,
         &S::spacing,
         spaced,
         {0.005, 10, 0.01, 1, true}},
        {"rate",
         "Rate",
         "per s",
         "Dabs per second of the method airbrush, also while the pointer rests.",
         "",
         Stroke,
         &S::rate,
         timed,
         {1, 500, 1, 100, true}},
        {"stabiliser",
         "Stabiliser",
         "radii",
         "Length of the rope on which the brush follows the pointer, so that a trembling hand draws a smooth line; 0: "
         "none.",
         "",
         Stroke,
         &S::stabiliser,
         follows,
         {0, 100, 0, 3}},
        {"symmetry",
         "Mirror",
         "",
         "Axes across which every dab is mirrored: \"x\" for the plane x = 0, \"y\", \"z\".",
         "",
         Symmetry,
         &sculpt::Symmetry::planes,
         always,
         {},
         Scope::AllTools},
        {"radial",
         "Radial",
         "",
         "Copies of every dab, turned evenly about an axis, in addition to its mirror images; 1: none.",
         "",
         Symmetry,
         &sculpt::Symmetry::copies,
         always,
         {1, 64, 1, 32, true},
         Scope::AllTools},
        {"radial-axis",
         "Axis",
         "",
         "Axis through the origin that the copies are turned about.",
         "",
         Symmetry,
         &sculpt::Symmetry::axis,
         turned,
         {},
         Scope::AllTools},
        {"snap",
         "Snap to edges",
         "radii",
         "The stroke keeps to edges that stay sharp, and to their corners, where one is so near; 0: to none.",
         "",
         Area,
         &S::snap,
         always,
         {0, 10, 0, 2}},
        {"front-facing", "Front faces", "", "Leaves alone what faces away from the viewer.", "", Area, &S::frontFacing,
         always},
        {"connected", "Connected", "",
         "Works only on what can be reached along the surface within the brush, not on the far side of a thin sheet.",
         "", Area, &S::connected, always},
        {"normal-radius",
         "Normal from",
         "radii",
         "Radius of the area whose mean normal gives tools their direction.",
         "",
         Area,
         &S::normalRadius,
         shapes,
         {0, 2, 0, 2}},
        {"plane-radius",
         "Plane from",
         "radii",
         "Radius of the area whose mean position gives tools' planes their place.",
         "",
         Area,
         &S::planeRadius,
         onPlane,
         {0, 2, 0, 2}},
        {"pressure-strength", "Strength", "", "Strength over pen pressure.", "No pressure left, full pressure right.",
         Pressure, &S::pressureStrength, dabs},
        {"pressure-radius", "Radius", "", "Radius over pen pressure, as a fraction of the full radius.", "", Pressure,
         &S::pressureRadius, dabs},
        {"stamp", "Stamp", "", "Grey image (PNG, JPEG) that the brush presses in: white has full effect, black none.",
         "", Stamp, &S::stamp, always},
        {"stamp-angle",
         "Angle",
         "degrees",
         "Turns the stamp to the left.",
         "",
         Stamp,
         &S::stampAngleRad,
         stamped,
         {-360, 360, -180, 180, false, Shown::Degrees}},
        {"stamp-follows", "Follow the stroke", "",
         "The stamp's upper edge leads along the stroke; off: the stamp stands upright in the view.", "", Stamp,
         &S::stampFollows, stamped},
        {"stamp-upright",
         "Upright",
         "",
         "Axis of the model that an upright stamp takes for upwards; the window writes the model's own.",
         "",
         Stamp,
         &S::stampUpright,
         stamped,
         {},
         Scope::Stroke},
        {"full-tap",
         "Full tap",
         "",
         "A tap, and an anchored stamp, are as strong as a stroke that goes over the place; the window asks for it.",
         "",
         Stroke,
         &S::fullTap,
         tapped,
         {},
         Scope::Stroke},
    };
    return rows;
}

} // namespace sculpt
