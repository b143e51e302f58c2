#include "core/sculpt/stroke/stroke_options.h"

#include <algorithm>
#include <numbers>

namespace sculpt {

constexpr OptionGroupRow groups[] = {
    {OptionGroup::Brush, "brush", "Brush", true},    {OptionGroup::Falloff, "falloff", "Falloff", true},
    {OptionGroup::Stroke, "stroke", "Stroke", true}, {OptionGroup::Symmetry, "symmetry", "Symmetry", true},
    {OptionGroup::Area, "area", "Area", false},      {OptionGroup::Pressure, "pressure", "Pressure", false},
    {OptionGroup::Stamp, "stamp", "Stamp", false},
};

std::span<const OptionGroupRow> optionGroupTable() {
    return groups;
}

/// In double, so that what was read is what is written.
static double unclampedOf(const OptionRange& range, float stored) {
    return range.shown == Shown::Degrees ? double(stored) * 180 / std::numbers::pi : double(stored);
}

/// Rounding must not take an end of the range out of it: the float next to 0.005 lies below.
double shownOf(const StrokeOption& option, float stored) {
    const double out = unclampedOf(option.range, stored), near = std::clamp(out, option.range.min, option.range.max);
    return storedOf(option, near) == stored ? near : out;
}

float storedOf(const StrokeOption& option, double shown) {
    return static_cast<float>(option.range.shown == Shown::Degrees ? shown * std::numbers::pi / 180 : shown);
}

void copyOptions(Scope scope, const StrokeSettings& from, StrokeSettings& to) {
    for (const StrokeOption& option : strokeOptionTable())
        if (option.scope == scope)
            std::visit([&](auto field) { at(to, field) = at(from, field); }, option.field);
}

StrokeSettings defaultsOf(const ToolRow& tool) {
    StrokeSettings out;
    out.tool = tool.id;
    out.strength = static_cast<float>(tool.strength);
    for (const ToolParameter& parameter : tool.parameters)
        out.parameters[parameter.id] = parameter.fallback;
    return out;
}

void setSource(StrokeSettings& settings, const base::Vec3d& fromContact) {
    for (const ToolParameter& parameter : tool(settings.tool).parameters)
        if (parameter.kind == ParameterKind::SourceX)
            settings.parameters[parameter.id] = fromContact.x;
        else if (parameter.kind == ParameterKind::SourceY)
            settings.parameters[parameter.id] = fromContact.y;
        else if (parameter.kind == ParameterKind::SourceZ)
            settings.parameters[parameter.id] = fromContact.z;
}

} // namespace sculpt
