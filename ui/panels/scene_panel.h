// The models of the scene: which is active, which are seen, which are locked; adding, renaming, removing and so on. It
// knows no document: it shows snapshots and asks for commands. Interface's thread only.
#pragma once

#include "ui/work/snapshot.h"

#include <nlohmann/json_fwd.hpp>
#include <QWidget>

class QTreeWidget;
class QTreeWidgetItem;
class QToolButton;

namespace ui {

class ScenePanel : public QWidget {
    Q_OBJECT
  public:
    explicit ScenePanel(QWidget* parent = nullptr);
    void show(const Snapshot& snapshot);
    /// As they are shown.
    QStringList names() const;

  Q_SIGNALS:
    void wanted(const nlohmann::json& command);
    void fileWanted(); ///< whose models are to be added

  private:
    void addList();
    void addButtons();
    QToolButton* button(const QString& label, const QString& tip, const char* name);
    void ask(const char* what);
    void clicked(QTreeWidgetItem* item, int column);
    void renamed(QTreeWidgetItem* item);
    std::string nameOf(const QTreeWidgetItem* item) const;

    QTreeWidget* m_list;
    std::vector<QToolButton*> m_ofSeveral; ///< of use where there is more than one model
    std::vector<SceneEntry> m_shown;
    std::size_t m_active = 0;
};

} // namespace ui
