// The bar of selection: how the pointer selects (ways of a table, one at a time), how that joins what is selected, and
// what is done to it at once. It asks; it changes nothing itself. Interface's thread only.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <QToolBar>
#include <span>

class QComboBox;
class QHBoxLayout;

namespace ui {

class FoldingRows;

/// A way to select with the pointer, as the bar shows it.
struct SelectChoice {
    const char* id; ///< "rectangle"
    const char* label;
    const char* tip;
};

class SelectBar : public QToolBar {
    Q_OBJECT
  public:
    explicit SelectBar(std::span<const SelectChoice> ways, QWidget* parent = nullptr);
    /// Of the picture that it floats over.
    void fitInto(int width);

    /// Of the way whose button is down; -1: none. Setting it does not emit.
    int way() const;
    void setWay(int way);
    /// As `select` names it: replace, add, subtract, intersect.
    QString mode() const;
    bool visibleOnly() const;
    /// What the buttons do, for menus.
    const QList<QAction*>& ways() const { return m_ways; }
    const QList<QAction*>& changes() const { return m_changes; }
    QAction* visibleAction() const { return m_visible; }

  Q_SIGNALS:
    void wayChosen(int way);                    ///< by the person; -1: none any more
    void wanted(const nlohmann::json& command); ///< what a button does to what is selected
    void stepWanted(const QString& action);     ///< "grow", "shrink": by a length that whoever listens knows

  private:
    void addWays(std::span<const SelectChoice> ways, QHBoxLayout& row);
    void addModes(QHBoxLayout& row);
    void addChanges(QHBoxLayout& second, QHBoxLayout& third);
    void addGroups(const std::vector<QList<QAction*>>& groups, QHBoxLayout& second, QHBoxLayout& third);

    FoldingRows* m_lines;
    QList<QAction*> m_ways, m_changes;
    QComboBox* m_mode = nullptr;
    QAction* m_visible = nullptr;
};

} // namespace ui
