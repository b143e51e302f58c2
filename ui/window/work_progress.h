// Long work as the person sees it: one bar for commands, measuring and meshes, shown only once work has lasted for
// `patienceMs`, and one way to stop it all. Interface's thread only.
#pragma once

#include <QElapsedTimer>
#include <QObject>

namespace ui {

class Editor;
class Measurer;
class Mesher;
class StatusLine;

class WorkProgress : public QObject {
    Q_OBJECT
  public:
    static constexpr qint64 patienceMs = 250;

    /// All outlive it.
    WorkProgress(Editor& editor, Measurer& measurer, Mesher& mesher, StatusLine& status, QObject* parent = nullptr);

    /// Asks all of it to stop; what it has not finished is as if it had not begun.
    void stop();

  Q_SIGNALS:
    void shown(double share, QString doing); ///< the bar is
    void rested();                           ///< nothing works any more

  private:
    bool working() const; ///< on something that tells its progress
    void show(double share, const QString& doing);
    void rest();

    Editor& m_editor;
    Measurer& m_measurer;
    Mesher& m_mesher;
    StatusLine& m_status;
    QElapsedTimer m_since; ///< the first report of the work under way
};

} // namespace ui
