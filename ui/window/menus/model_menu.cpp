#include "ui/window/command_dialog.h"
#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"
#include "ui/window/trim_tools.h"

#include <QAction>
#include <QMenu>

namespace ui {

static void ask(MainWindow& window, const session::CommandRow& row) {
    CommandDialog dialog(row, window.editor().snapshot(), &window);
    if (dialog.exec() == QDialog::Accepted)
        window.editor().run(dialog.command());
}

void addModelMenu(MainWindow& window) {
    QMenu* model = addMenu(window, "model", QObject::tr("&Model"));
    for (const session::CommandRow& row : session::commandTable()) {
        if (row.op == std::string_view("trim"))
            addTrimMenu(window, *model);
        if (!hasDialog(row))
            continue;
        QAction* action =
            addEntry(*model, row.op, QObject::tr("%1…").arg(row.label), {}, [&window, &row] { ask(window, row); });
        action->setToolTip(row.tip);
        action->setData(row.op);
    }
}

} // namespace ui
