#include "ui/panels/tool_bar.h"

#include "ui/panels/tool_grid.h"
#include "ui/theme/icon.h"
#include "ui/words/words.h"

#include <QActionGroup>

namespace ui {

static QString tipOf(const sculpt::ToolRow& row) {
    const QString shortcut = row.shortcut;
    const QString title =
        shortcut.isEmpty() ? spoken(row.label, "tool") : QString("%1  (%2)").arg(spoken(row.label, "tool"), shortcut);
    return QString("<b>%1</b><br>%2").arg(title, spoken(row.tip));
}

static QAction* actionOf(const sculpt::ToolRow& row, QObject* parent) {
    auto* action = new QAction(icon(row.icon), spoken(row.label, "tool"), parent);
    action->setCheckable(true);
    action->setData(row.id);
    action->setProperty(inEnglish, QString(row.label));
    action->setToolTip(tipOf(row));
    action->setStatusTip(spoken(row.tip));
    if (*row.shortcut)
        action->setShortcuts(QKeySequence::listFromString(row.shortcut));
    return action;
}

ToolBar::ToolBar(Settings& settings, QWidget* parent) : QToolBar(tr("Tools"), parent), m_tools(new QActionGroup(this)) {
    setObjectName("tools");
    setOrientation(Qt::Vertical);
    setMovable(false);
    auto* grid = new ToolGrid;
    for (const auto& row : sculpt::toolTable()) {
        QAction* action = actionOf(row, this);
        action->setChecked(&row == &settings.toolRow());
        m_tools->addAction(action);
        grid->add(*action);
    }
    addWidget(grid);
    connect(m_tools, &QActionGroup::triggered, this, [this, &settings](QAction* action) {
        settings.tool = action->data().toString().toStdString();
        Q_EMIT chosen();
    });
}

QList<QAction*> ToolBar::toolActions() const {
    return m_tools->actions();
}

} // namespace ui
