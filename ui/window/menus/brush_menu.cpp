#include "ui/panels/tool_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QMenu>

namespace ui {

void addBrushMenu(MainWindow& window) {
    constexpr double factor = 1.15, step = 0.05;
    BrushSizing& sizing = window.sculptView().sizing();
    QMenu* brush = addMenu(window, "brush", QObject::tr("&Brush"));
    brush->addActions(window.toolBar().toolActions());
    brush->addSeparator();
    addEntry(*brush, "", QObject::tr("Larger"), QKeySequence("]"), [&sizing] { sizing.scaleRadius(factor); });
    addEntry(*brush, "", QObject::tr("Smaller"), QKeySequence("["), [&sizing] { sizing.scaleRadius(1 / factor); });
    addEntry(*brush, "", QObject::tr("Stronger"), QKeySequence("Shift+]"), [&sizing] { sizing.shiftStrength(step); });
    addEntry(*brush, "", QObject::tr("Weaker"), QKeySequence("Shift+["), [&sizing] { sizing.shiftStrength(-step); });
}

} // namespace ui
