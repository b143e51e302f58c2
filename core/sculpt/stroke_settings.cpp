// What a stroke's settings may be: the one place that refuses them.
#include "core/base/error.h"
#include "core/sculpt/stroke.h"

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
    const auto known = std::find_if(row.parameters.begin(), row.parameters.end(),
                                    [&](const ToolParameter& parameter) { return id == parameter.id; });
    if (known != row.parameters.end())
        return inRange(known->id, value, known->min, known->max);
    std::string names;
    for (const ToolParameter& parameter : row.parameters)
        names += (names.empty() ? "" : ", ") + std::string(parameter.id);
    throw base::Error("the tool '" + std::string(row.id) + "' has no parameter '" + id + "'", "stroke",
                      names.empty() ? "it has none" : "it has " + names);
}

void check(const StrokeSettings& settings) {
    const ToolRow& row = tool(settings.tool);
    if (!(settings.radius > 0) || !std::isfinite(settings.radius))
        throw base::Error("radius is " + text(settings.radius), "stroke", "give a length greater than 0");
    inRange("strength", settings.strength, 0, 1);
    inRange("spacing", settings.spacing, 0.005, 10);
    for (const auto& [id, value] : settings.parameters)
        checkParameter(row, id, value);
}

} // namespace sculpt
