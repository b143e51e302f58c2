#include "ui/window/trim_tools.h"

#include "ui/interaction/picked_outline.h"
#include "ui/interaction/select_ways.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/words/words.h"

#include <nlohmann/json.hpp>
#include <QAction>
#include <QMenu>

namespace ui {

static void trim(MainWindow& window, PickShape shape, const Pick& pick) {
    nlohmann::json command = outlineOf(pick, shape, window.editor().snapshot().origin);
    command["op"] = "trim";
    command["keep"] = pick.modifiers.testFlag(Qt::ShiftModifier) ? "inside" : "outside";
    window.editor().run(command);
}

static void begin(MainWindow& window, const SelectWay& way) {
    if (window.editor().snapshot().surface.tree().empty())
        return window.tell(QObject::tr("There is no model to trim. Open one, or make one with File > New."));
    Picker& picker = window.sculptView().picker();
    picker.begin({way.shape, [&window, shape = way.shape](const Pick& pick) { trim(window, shape, pick); },
                  [&window] { window.showHint(); }, true});
    window.showHint(QObject::tr(way.tip) + ". " +
                    QObject::tr("What lies behind goes; Shift keeps it and nothing else; Esc goes back to sculpting."));
}

void addTrimMenu(MainWindow& window, QMenu& menu) {
    QMenu* trims = addMenu(window, "trim", QObject::tr("&Trim"), &menu);
    for (const SelectWay& way : selectWays()) {
        if (way.shape == PickShape::Place)
            continue;
        QAction* action = addEntry(*trims, "", QObject::tr("Trim by %1").arg(QObject::tr(way.label)), {},
                                   [&window, &way] { begin(window, way); });
        action->setData(QString("trim-%1").arg(way.id));
        action->setProperty(inEnglish, QString("Trim by %1").arg(way.label));
        action->setToolTip(QObject::tr("Cut straight through the model along an outline, and close it"));
    }
}

} // namespace ui
