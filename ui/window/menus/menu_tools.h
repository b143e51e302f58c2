// What all menus are made with: menus with a name to find them by, and their entries. Whatever an entry does ends with
// the window. Interface's thread only.
#pragma once

#include "ui/words/words.h"

#include <functional>
#include <QAction>
#include <QKeySequence>
#include <QString>

class QActionGroup;
class QMainWindow;
class QMenu;

namespace ui {

/// At the end of the menu bar, or of `parent`.
QMenu* addMenu(QMainWindow& window, const QString& name, const QString& title, QMenu* parent = nullptr);
/// `iconName` may be empty, `shortcut` too.
QAction* addEntry(QMenu& menu, const char* iconName, const QString& text, const QKeySequence& shortcut,
                  const std::function<void()>& work);
/// One of a group of which one is chosen. `id` is its data, by which tests find it, here and below.
QAction* addChoice(QMenu& menu, QActionGroup& group, const char* id, const QString& label, const QString& tip,
                   bool chosen, const std::function<void()>& choose);
/// The same, of a table's row.
template <class Row>
QAction* addChoice(QMenu& menu, QActionGroup& group, const Row& row, bool chosen, const std::function<void()>& choose) {
    QAction* out = addChoice(menu, group, row.id, spoken(row.label), spoken(row.tip), chosen, choose);
    out->setProperty(inEnglish, QString(row.label));
    return out;
}
/// From now on a click on one of its switches leaves the menu open: several are wanted at once.
void stayOpen(QMenu& menu);
/// On or off.
QAction* addSwitch(QMenu& menu, const char* id, const QString& label, const QString& tip, bool on,
                   const std::function<void(bool)>& turn);

} // namespace ui
