// One line that ends in "…" where it has no room, so that nobody takes a cut sentence for a whole one.
#pragma once

#include <QLabel>

namespace ui {

class ElidedLabel : public QLabel {
  public:
    using QLabel::QLabel;
    /// What can be read of it now.
    QString shownText() const;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace ui
