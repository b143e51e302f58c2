#include "core/sculpt/stroke/stroke_settings.h"

#include "core/base/row_of_id.h"

#include <algorithm>
#include <vector>

namespace sculpt {

constexpr MethodRow methods[] = {
    {StrokeMethod::Space, "space", "Space", "Dabs evenly along the surface.", false},
    {StrokeMethod::Dots, "dots", "Dots",
     "A dab at every sample of the pointer: the faster it moves, the farther apart.", false},
    {StrokeMethod::Airbrush, "airbrush", "Airbrush", "Dabs evenly in time, also while the pointer rests.", false},
    {StrokeMethod::Anchored, "anchored", "Anchored", "One dab where you press; drag for its size and turn.", true},
    {StrokeMethod::Line, "line", "Line", "Dabs along the straight line from press to release.", true},
};

std::span<const MethodRow> methodTable() {
    return methods;
}

const MethodRow& row(StrokeMethod method) {
    return *std::find_if(std::begin(methods), std::end(methods),
                         [&](const MethodRow& each) { return each.value == method; });
}

StrokeMethod method(std::string_view id) {
    return base::rowOf(methods, id, {"there is no stroke method '%'", "method", "choose one of %"}).value;
}

constexpr AxisRow axes[] = {{Axis::X, "x", "X axis"}, {Axis::Y, "y", "Y axis"}, {Axis::Z, "z", "Z axis"}};

std::span<const AxisRow> axisTable() {
    return axes;
}

const AxisRow& row(Axis axis) {
    return *std::find_if(std::begin(axes), std::end(axes), [&](const AxisRow& each) { return each.value == axis; });
}

Axis axis(std::string_view id) {
    return base::rowOf(axes, id, {"there is no axis '%'", "radial-axis", "choose one of %"}).value;
}

std::span<const UpAxisRow> upAxisTable() {
    static const auto rows = [] {
        std::vector<UpAxisRow> out;
        for (const base::UpRow& row : base::upTable())
            out.push_back({row.axis, row.id, row.id});
        return out;
    }();
    return rows;
}

const UpAxisRow& row(base::UpAxis axis) {
    return upAxisTable()[static_cast<std::size_t>(axis)];
}

base::UpAxis upAxis(std::string_view id) {
    return base::rowOf(upAxisTable(), id, {"there is no axis '%'", "stamp-upright", "choose one of %"}).value;
}

bool lastOnly(const StrokeSettings& settings) {
    return !holds(tool(settings.tool)) && row(settings.method).lastOnly;
}

} // namespace sculpt
