// Selecting and measuring: a bar over the picture for each, and a menu that holds the same actions for keys and the
// palette.
#include "ui/interaction/select_ways.h"
#include "ui/panels/measure_bar.h"
#include "ui/panels/select_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/measure_tools.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/window/select_tools.h"

#include <QAction>
#include <QMenu>

namespace ui {

/// The bar over the picture, hidden, and what shows it as the menu's first entry.
template <class Bar>
static void addBar(MainWindow& window, QMenu& menu, Bar& bar, const char* key, const QString& tip) {
    bar.hide();
    window.bars().add(bar, [&bar](int width) { bar.fitInto(width); });
    QAction* shown = bar.toggleViewAction();
    shown->setText(QObject::tr("Show the &Bar"));
    shown->setShortcut(QKeySequence(key));
    shown->setToolTip(tip);
    menu.addAction(shown);
    menu.addSeparator();
}

void addSelectMenu(MainWindow& window) {
    QMenu* menu = addMenu(window, "select", QObject::tr("&Select"));
    std::vector<SelectChoice> choices;
    for (const SelectWay& way : selectWays())
        choices.push_back({way.id, way.label, way.tip});
    auto* bar = new SelectBar(choices, &window);
    addBar(window, *menu, *bar, "B",
           QObject::tr("Choose parts of the model with the pointer, for commands to work on"));
    menu->addActions(bar->ways());
    menu->addSeparator();
    menu->addAction(bar->visibleAction());
    menu->addSeparator();
    menu->addActions(bar->changes());
    new SelectTools(window, *bar);
}

void addMeasureMenu(MainWindow& window) {
    QMenu* menu = addMenu(window, "measure", QObject::tr("Meas&ure"));
    auto* bar = new MeasureBar(&window);
    addBar(window, *menu, *bar, "Shift+M",
           QObject::tr("Distances, angles and thickness between places that you click"));
    menu->addActions(bar->rows());
    menu->addSeparator();
    menu->addActions(bar->results());
    auto* tools = new MeasureTools(window, *bar);
    window.sculptView().overlay().above = [tools](QPainter& painter, const render::Camera& seen) {
        tools->paint(painter, seen);
    };
}

} // namespace ui
