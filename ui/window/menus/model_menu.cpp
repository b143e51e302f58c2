#include "ui/window/command_desk.h"
#include "ui/window/command_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/window/menus/model_groups.h"
#include "ui/window/trim_tools.h"

#include <algorithm>
#include <QAction>
#include <QMenu>

namespace ui {

static void addCommand(MainWindow& window, CommandDesk& desk, QMenu& menu, const session::CommandRow& row) {
    if (row.op == std::string_view("trim"))
        return addTrimMenu(window, menu);
    if (!hasDialog(row))
        return;
    QAction* action =
        addEntry(menu, row.op, QObject::tr("%1…").arg(spoken(row.label)), {}, [&desk, &row] { desk.open(row); });
    action->setToolTip(spoken(row.tip));
    action->setData(row.op);
    action->setProperty(inEnglish, QString("%1…").arg(row.label));
}

/// The group's commands as it names them, then what it does not name.
static std::vector<const session::CommandRow*> commandsOf(const ModelGroup& group) {
    std::vector<const session::CommandRow*> out;
    for (const session::CommandRow& row : session::commandTable())
        if (&groupOf(row.op) == &group)
            out.push_back(&row);
    std::ranges::stable_sort(out, {}, [&](const session::CommandRow* row) { return placeIn(group, row->op); });
    return out;
}

void addModelMenu(MainWindow& window) {
    QMenu* model = addMenu(window, "model", QObject::tr("M&odel"));
    auto* desk = new CommandDesk(window);
    for (const ModelGroup& group : modelGroups()) {
        QMenu* menu = addMenu(window, group.id, QObject::tr(group.title), model);
        for (const session::CommandRow* row : commandsOf(group))
            addCommand(window, *desk, *menu, *row);
    }
}

} // namespace ui
