// How dragging turns the view. One row for each style: menu, settings, tip and tests loop over the table.
//
//     turntable   about the model's upright axis; up stays up
//     orbit       about the image's own axes, over the poles and on
//     trackball   a ball around the image's middle follows the pointer; beyond its outline it rolls
//     fly         the eye stays and looks around; with F4 the keys move it (fly.h)
//
// A drag is a function of its two points alone: there is no state, and a trackball drag back undoes the drag there.
#pragma once

#include "ui/view/view.h"

#include <string_view>

namespace ui {

/// In pixels, (0, 0) at the upper left.
struct ImagePoint {
    double x = 0, y = 0;
};

struct NavigationRow {
    const char* id; ///< "turntable"
    const char* label;
    const char* tip;
    bool upright; ///< the view is put upright when the style is chosen
    void (*drag)(View& view, const ImagePoint& from, const ImagePoint& to, int width, int height);
};

std::span<const NavigationRow> navigationTable();
/// The row of that id; without one, the first.
const NavigationRow& navigation(std::string_view id);

} // namespace ui
