#include "ui/window/menus/model_groups.h"

#include <algorithm>
#include <QObject>
#include <ranges>

namespace ui {

std::span<const ModelGroup> modelGroups() {
    static const ModelGroup rows[] = {
        {"clean-up", QT_TR_NOOP("C&lean Up"), "clean outliers mixed duplicates denoise normals orient flip"},
        {"sampling", QT_TR_NOOP("&Sampling"), "resample thin reduce refine"},
        {"holes-and-cuts", QT_TR_NOOP("Holes and &Cuts"), "fill bridge cut trim mirror"},
        {"solids", QT_TR_NOOP("S&olids"), "solid primitive drill tube merge hollow shell extrude"},
        {"shape", QT_TR_NOOP("S&hape"), "transform align unit smooth sharpen inflate noise crease"},
        {"selected", QT_TR_NOOP("What Is S&elected"),
         "delete keep hide show duplicate colour levels select selection mask"},
        {"compare", QT_TR_NOOP("Co&mpare"), "measure shapes register blend"},
        {"further", QT_TR_NOOP("&Further"), ""},
    };
    return rows;
}

std::size_t placeIn(const ModelGroup& group, std::string_view op) {
    std::size_t place = 0;
    for (const auto each : std::views::split(group.ops, ' ')) {
        if (std::ranges::equal(each, op))
            return place;
        ++place;
    }
    return std::string_view::npos;
}

const ModelGroup& groupOf(std::string_view op) {
    for (const ModelGroup& each : modelGroups())
        if (placeIn(each, op) != std::string_view::npos)
            return each;
    return modelGroups().back();
}

} // namespace ui
