// Help: every shortcut of the window's actions, and what the pointer does in the viewport.
#pragma once

#include <QDialog>
#include <span>

class QMainWindow;

namespace ui {

class ShortcutsDialog : public QDialog {
    Q_OBJECT
  public:
    explicit ShortcutsDialog(const QMainWindow& window, QWidget* parent = nullptr);
};

/// What the pointer does: gesture and effect.
struct GestureRow {
    const char* gesture;
    const char* effect;
};
std::span<const GestureRow> gestureTable();

} // namespace ui
