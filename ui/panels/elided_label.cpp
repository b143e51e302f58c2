#include "ui/panels/elided_label.h"

#include <QPainter>
#include <QStyle>

namespace ui {

static QRect placeOf(const QLabel& label) {
    return label.contentsRect().adjusted(std::max(label.indent(), 0), 0, 0, 0);
}

QString ElidedLabel::shownText() const {
    return fontMetrics().elidedText(text(), Qt::ElideRight, placeOf(*this).width());
}

QSize ElidedLabel::minimumSizeHint() const {
    constexpr int letters = 8;
    return {letters * fontMetrics().averageCharWidth(), QLabel::minimumSizeHint().height()};
}

void ElidedLabel::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    style()->drawItemText(&painter, placeOf(*this), static_cast<int>(Qt::AlignVCenter | Qt::AlignLeft), palette(),
                          isEnabled(), shownText(), foregroundRole());
}

} // namespace ui
