// What a stroke's settings may be: the one place that refuses them.
#include "core/base/error.h"
#include "core/base/near_word.h"
#include "core/base/row_of_id.h"
#include "core/base/short_number.h"
#include "core/sculpt/stroke/stroke_options.h"

namespace sculpt {

[[noreturn]] static void refuse(const char* id, double value, double min, double max) {
    throw base::Error(std::string(id) + " is " + base::shortNumber(value), "stroke",
                      min == OptionRange::aboveZero
                          ? "give a length greater than 0"
                          : "give a number from " + base::shortNumber(min) + " to " + base::shortNumber(max));
}

static void checkParameter(const ToolRow& row, const std::string& id, double value) {
    if (const ToolParameter* known = base::findRow(row.parameters, id)) {
        if (!(value >= known->min && value <= known->max))
            refuse(known->id, value, known->min, known->max);
        return;
    }
    const std::string names = base::joinedIds(row.parameters);
    throw base::Error("the tool '" + std::string(row.id) + "' has no parameter '" + id + "'", "stroke",
                      base::didYouMeanOr(id, names + ", samples, " + base::joinedIds(strokeOptionTable()),
                                         names.empty() ? "it has none" : "it has " + names));
}

namespace {

/// Of one option; what has no range of its own passes.
struct Check {
    const StrokeOption& option;

    /// The ends are those that the field can hold: 0.1 as a float is more than 0.1.
    void operator()(float value) const {
        const OptionRange& range = option.range;
        if (!(value >= storedOf(option, range.min) && value <= storedOf(option, range.max)))
            refuse(option.id, shownOf(option, value), range.min, range.max);
    }
    void operator()(int value) const {
        if (!(value >= option.range.min && value <= option.range.max))
            refuse(option.id, value, option.range.min, option.range.max);
    }
    void operator()(const CurvePoints& points) const { BrushCurve(points, option.id); }
    void operator()(Axis value) const {
        if (value < Axis::X || value > Axis::Z)
            refuse(option.id, static_cast<int>(value), 0, 2);
    }
    template <class Other>
    void operator()(const Other&) const {}
};

} // namespace

void check(const StrokeSettings& settings) {
    const ToolRow& row = tool(settings.tool);
    for (const StrokeOption& option : strokeOptionTable())
        std::visit([&](auto field) { Check{option}(at(settings, field)); }, option.field);
    for (const auto& [id, value] : settings.parameters)
        checkParameter(row, id, value);
}

} // namespace sculpt
