// The line at the bottom: messages left, the model's figures right, and the progress of long work when there is some.
#pragma once

#include "ui/work/frame.h"
#include "ui/work/snapshot.h"

#include <QStatusBar>

class QLabel;
class QProgressBar;
class QToolButton;

namespace ui {

/// "512 B", "3.4 MB": powers of 1000, three digits.
QString bytesText(std::size_t bytes);

class StatusLine : public QStatusBar {
    Q_OBJECT
  public:
    explicit StatusLine(QWidget* parent = nullptr);

    void showModel(const Snapshot& snapshot);
    /// How far the true surface has come; nothing: splats are shown.
    void showRefinement(const std::optional<Refinement>& refinement);
    void showFrame(double seconds, const QString& renderer);
    /// `share` 0 to 1.
    void showProgress(double share, const QString& doing);
    void hideProgress();
    /// Stays until the next one; an error is marked.
    void tell(const QString& message, bool error = false);
    QString message() const;

  Q_SIGNALS:
    void cancelled(); ///< the person asked the work to stop

  private:
    QLabel* cell(const QString& tip);

    QLabel *m_message, *m_surfels, *m_memory, *m_spacing, *m_frame, *m_truth, *m_dab;
    QProgressBar* m_progress;
    QToolButton* m_stop;
};

} // namespace ui
