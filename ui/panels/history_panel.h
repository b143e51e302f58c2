// Every step of the model's history by name, the present one marked, those that undo has left behind it faint: a click
// goes there. Below, how much memory the steps may hold. It knows no document: it shows snapshots and says what is
// wanted. Interface's thread only.
#pragma once

#include "ui/work/snapshot.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QListWidget;

namespace ui {

class HistoryPanel : public QWidget {
    Q_OBJECT
  public:
    explicit HistoryPanel(int budgetMib, QWidget* parent = nullptr);

    void show(const Snapshot& snapshot);
    /// As they are shown, the oldest first; of them, the present one.
    QStringList labels() const;
    int present() const { return m_present; }

  Q_SIGNALS:
    void wanted(int steps); ///< forward, or back where negative; never 0
    void budgetChosen(int mib);

  private:
    QListWidget* m_list;
    QLabel* m_held;
    QComboBox* m_budget;
    std::vector<std::string> m_past, m_future; ///< shown now
    int m_present = 0;
};

} // namespace ui
