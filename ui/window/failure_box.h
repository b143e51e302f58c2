// Tells why a command failed, in a box with the title of what the person wanted. Interface's thread only.
#pragma once

#include <QMainWindow>

namespace ui {

class Editor;

class FailureBox : public QObject {
    Q_OBJECT
  public:
    /// Both outlive it.
    FailureBox(QMainWindow& window, const Editor& editor, QObject* parent = nullptr);

    /// Before a command: no failure yet.
    void clear() { m_failure.clear(); }
    /// After it: what the editor has told since. Nothing where the person cancelled.
    void show(const QString& title);
    void show(const QString& title, const QString& failure);

  private:
    QMainWindow& m_window;
    QString m_failure; ///< the last that a command told
};

} // namespace ui
