#include "ui/tool_bar.h"

#include "ui/icon.h"

#include <QActionGroup>

namespace ui {

static QString tipOf(const sculpt::ToolRow& row) {
    const QString shortcut = row.shortcut;
    const QString title = shortcut.isEmpty() ? QString(row.label) : QString("%1  (%2)").arg(row.label, shortcut);
    return QString("<b>%1</b><br>%2").arg(title, row.tip);
}

ToolBar::ToolBar(Settings& settings, QWidget* parent) : QToolBar(tr("Tools"), parent), m_tools(new QActionGroup(this)) {
    setObjectName("tools");
    setOrientation(Qt::Vertical);
    setMovable(false);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIconSize({24, 24});
    for (const auto& row : sculpt::toolTable()) {
        QAction* action = addAction(icon(row.icon), row.label);
        action->setCheckable(true);
        action->setData(row.id);
        action->setToolTip(tipOf(row));
        action->setStatusTip(row.tip);
        action->setShortcut(QKeySequence(row.shortcut));
        action->setChecked(&row == &settings.toolRow());
        m_tools->addAction(action);
    }
    connect(m_tools, &QActionGroup::triggered, this, [this, &settings](QAction* action) {
        settings.tool = action->data().toString().toStdString();
        emit chosen();
    });
}

QList<QAction*> ToolBar::toolActions() const {
    return m_tools->actions();
}

} // namespace ui
