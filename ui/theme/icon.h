// The program's icons: simple SVG drawings of icons/, drawn here rather than by a plug-in that may be missing, in the
// theme's colour and at the size and scale at which they are shown.
#pragma once

#include <QIcon>
#include <string_view>

namespace ui {

/// The drawing `name` ("undo", or as tables name it, "icons/tool-draw.svg"), dimmed where disabled; a null icon if
/// there is none of that name.
QIcon icon(std::string_view name);

/// Of the lines of all icons from now on, those that are there too.
void setIconColour(const QColor& colour);

} // namespace ui
