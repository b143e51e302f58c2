// Asks about work that a crash has left, and shows it before: a picture of the model as it would come back, and what
// was done to it. Interface's thread only.
#pragma once

#include "ui/work/recovery_preview.h"

#include <QDialog>

class QLabel;

namespace ui {

class RecoveryDialog : public QDialog {
    Q_OBJECT
  public:
    enum Answer { Later = QDialog::Rejected, Recover = QDialog::Accepted, Discard };

    RecoveryDialog(const session::LeftJournal& journal, QWidget* parent = nullptr);
    /// By `exec` or `result`: an Answer. Of the picture: null until it is there.
    QImage picture() const { return m_shown; }

  private:
    void showPicture(const QImage& picture, const QString& steps);

    QLabel *m_picture, *m_steps;
    QImage m_shown;
    RecoveryPreview m_preview;
};

} // namespace ui
