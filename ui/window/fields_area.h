// The fields of a dialog, which are scrolled where a screen has no room for all of them: never too narrow for them,
// also where they grow later.
#pragma once

#include <QScrollArea>

namespace ui {

class FieldsArea : public QScrollArea {
  public:
    /// Takes the fields. `screen`: its height in pixels.
    FieldsArea(QWidget& fields, int screen);
    QSize minimumSizeHint() const override;

  protected:
    bool eventFilter(QObject* object, QEvent* event) override;
};

} // namespace ui
