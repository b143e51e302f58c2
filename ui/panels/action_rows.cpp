#include "ui/panels/action_rows.h"

#include <QAction>
#include <QFrame>
#include <QHBoxLayout>
#include <QToolBar>
#include <QToolButton>

namespace ui {

QAction* barAction(QToolBar& bar, const QString& label, const QString& tip, const QString& name) {
    auto* out = new QAction(label, &bar);
    out->setToolTip(tip);
    out->setObjectName(bar.objectName() + '-' + name);
    return out;
}

void addButtons(QHBoxLayout& row, const QList<QAction*>& actions) {
    for (QAction* action : actions) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setObjectName(action->objectName());
        button->setFocusPolicy(Qt::NoFocus);
        row.addWidget(button);
    }
}

void addGap(QHBoxLayout& row) {
    auto* line = new QFrame;
    line->setFrameShape(QFrame::VLine);
    line->setObjectName("gap");
    row.addWidget(line);
}

int checkedOf(const QList<QAction*>& actions) {
    for (qsizetype i = 0; i < actions.size(); ++i)
        if (actions[i]->isChecked())
            return static_cast<int>(i);
    return -1;
}

void checkOnly(const QList<QAction*>& actions, int which) {
    for (qsizetype i = 0; i < actions.size(); ++i)
        actions[i]->setChecked(i == which);
}

} // namespace ui
