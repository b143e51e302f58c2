// The look: a palette and one small style sheet, dark or light, the same on every desktop.
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>
#include <span>
#include <string_view>

class QApplication;

namespace ui {

struct ThemeRow {
    const char *id, *label, *tip;
};
/// The first is what it is where nobody chose.
std::span<const ThemeRow> themeTable();

/// From now on, for all windows, those that are open too; an unknown id is the table's first.
void applyTheme(QApplication& application, std::string_view id = "dark");

/// Of x, y, z.
inline QColor axisColour(int axis) {
    return axis == 0 ? QColor(226, 84, 84) : axis == 1 ? QColor(122, 186, 66) : QColor(84, 140, 232);
}

/// Of words about what went wrong, as a style sheet, readable on the palette's ground.
inline QString troubleStyle(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() > 127 ? "color: #b3261e;" : "color: #ff8a75;";
}

} // namespace ui
