// What hands do in the viewport: one table, which the list of shortcuts and the manual loop over.
#pragma once

#include <span>

namespace ui {

struct GestureRow {
    const char* gesture; ///< "Shift + left button"
    const char* effect;  ///< "Smooth"
};

std::span<const GestureRow> gestureTable();

} // namespace ui
