// The line at the bottom: messages left, the model's figures right, and the progress of long work when there is some.
// Where it is narrow the least wanted figures give way. A message is a sentence; it goes after a while, and then the
// line says what the pointer does now. Where a command has told several, a button beside it opens all of them.
#pragma once

#include "ui/work/frame.h"
#include "ui/work/snapshot.h"

#include <QSet>
#include <QStatusBar>
#include <QTimer>

class QLabel;
class QProgressBar;
class QToolButton;

namespace ui {

/// "512 B", "3.4 MB": powers of 1000, three digits.
QString bytesText(std::size_t bytes);
/// A capital letter first and a full stop at the end, whatever wrote it.
QString sentenceOf(const QString& message);

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
    /// An error is marked and stays longer. A line for each sentence.
    void tell(const QString& message, bool error = false);
    /// What stands here while there is no message.
    void setHint(const QString& hint);
    QString message() const;
    /// All that was told at last, a line for each sentence.
    QString allTold() const;

  Q_SIGNALS:
    void cancelled(); ///< the person asked the work to stop

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    QLabel* cell(const QString& tip);
    void want(QLabel* cell, bool wanted, const QString& text);
    void fit();
    void showAll();

    QLabel *m_message, *m_surfels, *m_memory, *m_spacing, *m_frame, *m_truth, *m_dab;
    QSet<QLabel*> m_wanted; ///< cells that have something to say
    QString m_hint;
    QTimer m_stale; ///< until the message has been read
    QProgressBar* m_progress;
    QToolButton *m_stop, *m_more;
    QStringList m_told; ///< at last
};

} // namespace ui
