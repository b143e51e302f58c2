#include "ui/window/fields_area.h"

#include <algorithm>
#include <QEvent>
#include <QScrollBar>

namespace ui {

FieldsArea::FieldsArea(QWidget& fields, int screen) {
    constexpr int others = 240, least = 100; // pixels: what stands above and below
    setWidget(&fields);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumHeight(std::clamp(fields.sizeHint().height(), least, std::max(least, screen - others)));
}

QSize FieldsArea::minimumSizeHint() const {
    constexpr int narrow = 400;
    const int bar = verticalScrollBar()->sizeHint().width() + 2 * frameWidth();
    return {std::max(narrow, widget()->minimumSizeHint().width() + bar), QScrollArea::minimumSizeHint().height()};
}

bool FieldsArea::eventFilter(QObject* object, QEvent* event) {
    if (event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(object, event);
}

} // namespace ui
