// How dragging turns the view. One row for each style: menu, settings, tip and tests loop over the table.
//
//     turntable   about the model's upright axis; up stays up
//     orbit       about the image's own axes, over the poles and on
//     trackball   a ball around the image's middle follows the pointer; beyond its outline it rolls
//     fly         the eye stays and looks around; with F4 the keys move it (fly.h)
//
// Drags are functions of the two places alone: no state, and for the trackball the way back undoes the way there.
#pragma once

#include "ui/view/view.h"

#include <string_view>

namespace ui {

/// A place of the image in pixels, (0, 0) upper left.
struct ImagePlace {
    double x = 0, y = 0;
};

struct NavigationRow {
    const char* id; ///< "turntable"
    const char* label;
    const char* tip;
    bool upright; ///< the view is put upright when the style is chosen
    void (*drag)(View& view, const ImagePlace& from, const ImagePlace& to, int width, int height);
};

std::span<const NavigationRow> navigationTable();
/// The first row where there is none of that name.
const NavigationRow& navigation(std::string_view id);

} // namespace ui
