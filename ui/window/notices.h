// What the viewport says of work that takes a while: what is being opened, from the first moment; long work, once the
// status line's bar shows it; slow levels of the true surface. One at a time, in this order. Interface's thread only.
#pragma once

#include "ui/interaction/sculpt_view.h"
#include "ui/work/frame.h"

namespace ui {

class FileActions;
class WorkProgress;

class Notices : public QObject {
    Q_OBJECT
  public:
    /// All outlive it.
    Notices(SculptView& view, const Editor& editor, const FileActions& files, const WorkProgress& progress,
            QObject* parent = nullptr);

    /// "Opening bunny.ply", while that is under way; else empty.
    const QString& coming() const { return m_coming; }
    /// Of the picture that is shown; nothing: splats.
    void refine(const std::optional<Refinement>& refinement);

  Q_SIGNALS:
    void comingChanged();

  private:
    void come(const QString& what);
    void work(const QString& doing, double share);
    void show();

    SculptView& m_view;
    QString m_coming;
    Notice m_work, m_refining;
};

} // namespace ui
