// Help: every shortcut of the window's actions, and what the pointer does in the viewport.
#pragma once

#include <QDialog>

class QMainWindow;

namespace ui {

class ShortcutsDialog : public QDialog {
    Q_OBJECT
  public:
    explicit ShortcutsDialog(const QMainWindow& window, QWidget* parent = nullptr);
};

} // namespace ui
