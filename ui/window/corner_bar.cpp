#include "ui/window/main_window.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace ui {

void addCornerBar(MainWindow& window) {
    auto* bar = new QToolBar;
    bar->setObjectName("corner");
    bar->setIconSize({18, 18});
    bar->setFixedHeight(24); // no taller than the menus beside it
    for (QAction* action : window.menu("file")->actions())
        if (action->shortcut() == QKeySequence::Open || action->shortcut() == QKeySequence::Save)
            bar->addAction(action);
    bar->addActions(window.menu("edit")->actions()); // undo, redo
    bar->addAction(window.findChild<QAction*>("frame-all"));
    window.menuBar()->setCornerWidget(bar);
}

} // namespace ui
