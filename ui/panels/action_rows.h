// Rows of actions that a bar shows as buttons, and that menus, keys and the palette hold as well. Interface's thread
// only.
#pragma once

#include <QList>
#include <QString>

class QAction;
class QHBoxLayout;
class QToolBar;

namespace ui {

/// An action of the bar's, named by both: "measure-distance".
QAction* barAction(QToolBar& bar, const QString& label, const QString& tip, const QString& name);
/// A button for each, of the action's name; the keyboard stays with the picture.
void addButtons(QHBoxLayout& row, const QList<QAction*>& actions);
/// A line between two groups of buttons.
void addGap(QHBoxLayout& row);

/// The place in the list of the checked one; -1: none.
int checkedOf(const QList<QAction*>& actions);
/// At most one; -1: none. Emits no `triggered`.
void checkOnly(const QList<QAction*>& actions, int which);

} // namespace ui
