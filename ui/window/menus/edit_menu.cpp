#include "ui/window/main_window.h"
#include "ui/window/menus/menu_tools.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QShortcut>

namespace ui {

/// What undo and redo would do now, in their entries.
static void showSteps(const Snapshot& now, QAction& undo, QAction& redo) {
    undo.setEnabled(now.canUndo);
    undo.setText(now.canUndo ? QObject::tr("Undo %1").arg(spoken(now.undoLabel, "step")) : QObject::tr("Undo"));
    redo.setEnabled(now.canRedo);
    redo.setText(now.canRedo ? QObject::tr("Redo %1").arg(spoken(now.redoLabel, "step")) : QObject::tr("Redo"));
}

void addEditMenu(MainWindow& window) {
    QMenu* edit = addMenu(window, "edit", QObject::tr("&Edit"));
    QAction* undo = addEntry(*edit, "undo", QObject::tr("Undo"), QKeySequence("Ctrl+Z"), [&window] { window.undo(); });
    QAction* redo =
        addEntry(*edit, "redo", QObject::tr("Redo"), QKeySequence("Ctrl+Shift+Z"), [&window] { window.redo(); });
    redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    undo->setObjectName("undo");
    redo->setObjectName("redo");
    QAction* history = window.findChild<QDockWidget*>("history")->toggleViewAction();
    history->setText(QObject::tr("&History"));
    history->setShortcut(QKeySequence("Ctrl+H"));
    history->setToolTip(QObject::tr("All steps by name: click one to go there"));
    edit->addAction(history);
    QAction* console = window.findChild<QDockWidget*>("console")->toggleViewAction();
    console->setText(QObject::tr("&Console"));
    console->setShortcut(QKeySequence("Ctrl+`"));
    console->setToolTip(QObject::tr("Every action as a line of a session, and a field that takes such lines"));
    edit->addAction(console);
    const auto show = [&editor = window.editor(), undo, redo] { showSteps(editor.snapshot(), *undo, *redo); };
    QObject::connect(&window.editor(), &Editor::changed, edit, show);
    show();
    auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), &window);
    QObject::connect(escape, &QShortcut::activated, &window, &MainWindow::escape);
}

} // namespace ui
