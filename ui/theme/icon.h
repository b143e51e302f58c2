// The program's icons: simple SVG drawings of icons/, drawn here rather than by a plug-in that may be missing.
#pragma once

#include <QIcon>
#include <string_view>

namespace ui {

/// The drawing `name` ("undo", or as tables name it, "icons/tool-draw.svg") at the usual sizes, dimmed where disabled;
/// a null icon if there is none of that name.
QIcon icon(std::string_view name);

} // namespace ui
