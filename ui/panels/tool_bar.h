// The tools down the left side: one button per row of sculpt::toolTable(), in columns (tool_grid.h). Nothing else here
// knows a tool.
#pragma once

#include "ui/settings/settings.h"

#include <QToolBar>

class QActionGroup;

namespace ui {

class ToolBar : public QToolBar {
    Q_OBJECT
  public:
    ToolBar(Settings& settings, QWidget* parent = nullptr);
    /// One action per row, in the table's order; `data()` is the tool's id.
    QList<QAction*> toolActions() const;

  Q_SIGNALS:
    void chosen(); ///< settings.tool has changed

  private:
    QActionGroup* m_tools;
};

} // namespace ui
