// What a stroke's settings may be: the one place that refuses them.
#include "core/sculpt/stroke_settings.h"
#include "core/base/error.h"
#include "core/base/row_of_id.h"
#include "core/sculpt/stroke_options.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

static std::string text(double value) {
    char out[32];
    std::snprintf(out, sizeof out, "%g", value);
    return out;
}

static void inRange(const char* name, double value, double min, double max) {
    if (!(value >= min && value <= max))
        throw base::Error(std::string(name) + " is " + text(value), "stroke",
                          "give a number from " + text(min) + " to " + text(max));
}

static void checkParameter(const ToolRow& row, const std::string& id, double value) {
    if (const ToolParameter* known = base::findRow(row.parameters, id))
        return inRange(known->id, value, known->min, known->max);
    const std::string names = base::joinedIds(row.parameters);
    throw base::Error("the tool '" + std::string(row.id) + "' has no parameter '" + id + "'", "stroke",
                      names.empty() ? "it has none" : "it has " + names);
}

constexpr MethodRow methods[] = {
    {StrokeMethod::Space, "space", "Space", "Dabs evenly along the surface.", false},
    {StrokeMethod::Dots, "dots", "Dots", "A dab wherever the pointer is seen: the faster it goes, the farther apart.",
     false},
    {StrokeMethod::Airbrush, "airbrush", "Airbrush", "Dabs evenly in time, also while the pointer rests.", false},
    {StrokeMethod::Anchored, "anchored", "Anchored", "One dab where you press; drag for its size and turn.", true},
    {StrokeMethod::Line, "line", "Line", "Dabs along the straight line from press to release.", true},
};

std::span<const MethodRow> methodTable() {
    return methods;
}

const MethodRow& row(StrokeMethod method) {
    return *std::find_if(std::begin(methods), std::end(methods),
                         [&](const MethodRow& each) { return each.method == method; });
}

StrokeMethod method(std::string_view id) {
    return base::rowOf(methods, id, {"there is no stroke method '%'", "method", "choose one of %"}).method;
}

bool lastOnly(const StrokeSettings& settings) {
    return !holds(tool(settings.tool)) && row(settings.method).lastOnly;
}

static void checkSymmetry(const Symmetry& symmetry) {
    inRange("radial", symmetry.copies, 1, 64);
    inRange("radial-axis", symmetry.axis, 0, 2);
}

static void checkOption(const StrokeOption& option, const StrokeSettings& settings) {
    if (const auto* number = std::get_if<float StrokeSettings::*>(&option.field))
        inRange(option.id, double(settings.**number) * option.range.scale, option.range.min, option.range.max);
    if (const auto* curve = std::get_if<CurvePoints StrokeSettings::*>(&option.field))
        BrushCurve(settings.**curve, option.id);
}

void check(const StrokeSettings& settings) {
    const ToolRow& row = tool(settings.tool);
    if (!(settings.radius > 0) || !std::isfinite(settings.radius))
        throw base::Error("radius is " + text(settings.radius), "stroke", "give a length greater than 0");
    for (const StrokeOption& option : strokeOptionTable())
        checkOption(option, settings);
    checkSymmetry(settings.symmetry);
    for (const auto& [id, value] : settings.parameters)
        checkParameter(row, id, value);
}

} // namespace sculpt
