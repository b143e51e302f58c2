#include "ui/window/main_window.h"
#include "ui/window/menus/menus.h"

#include <QAction>
#include <QHBoxLayout>
#include <QMenu>
#include <QMenuBar>
#include <QToolButton>

namespace ui {

void addCornerBar(MainWindow& window) {
    auto* bar = new QWidget;
    bar->setObjectName("corner");
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 6, 0);
    row->setSpacing(2);
    const auto add = [&](QAction* action) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setIconSize({18, 18});
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    };
    for (QAction* action : window.menu("file")->actions())
        if (action->shortcut() == QKeySequence::Open || action->shortcut() == QKeySequence::Save)
            add(action);
    for (const char* name : {"undo", "redo", "frame-all"})
        add(window.findChild<QAction*>(name));
    window.menuBar()->setCornerWidget(bar);
}

} // namespace ui
