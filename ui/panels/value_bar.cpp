#include "ui/panels/value_bar.h"

#include <algorithm>
#include <cmath>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace ui {

/// Pixels that a hand trembles when it clicks.
constexpr int slack = 3;
/// A fine drag goes this part of the way.
constexpr double fine = 0.1;

ValueBar::ValueBar(const QString& label, QWidget* parent) : QSlider(Qt::Horizontal, parent), m_label(label) {
    setCursor(Qt::SizeHorCursor);
    setFixedHeight(height);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
}

void ValueBar::setText(const QString& value) {
    m_text = value;
    update();
}

void ValueBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF all = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath outline;
    outline.addRoundedRect(all, 4, 4);
    painter.fillPath(outline, palette().base());
    const double share = double(value() - minimum()) / std::max(1, maximum() - minimum());
    painter.save();
    painter.setClipPath(outline);
    QColor filled = palette().highlight().color();
    filled.setAlphaF(underMouse() || hasFocus() ? 0.5f : 0.36f);
    if (isEnabled())
        painter.fillRect(QRectF(all.left(), all.top(), all.width() * share, all.height()), filled);
    painter.restore();
    if (hasFocus()) {
        painter.setPen(palette().highlight().color());
        painter.drawPath(outline);
    }
    const QRect inside = rect().adjusted(8, 0, -8, 0);
    painter.setPen(palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text));
    painter.drawText(inside, Qt::AlignRight | Qt::AlignVCenter, m_text);
    const int room = inside.width() - fontMetrics().horizontalAdvance(m_text) - 6;
    QColor faint = palette().color(QPalette::Text);
    faint.setAlphaF(0.8f);
    painter.setPen(faint);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, fontMetrics().elidedText(m_label, Qt::ElideRight, room));
}

void ValueBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    m_from = qRound(event->position().x());
    m_at = value();
    m_dragged = false;
    setSliderDown(true);
    event->accept();
}

void ValueBar::mouseMoveEvent(QMouseEvent* event) {
    if (!isSliderDown())
        return update();
    const int x = qRound(event->position().x());
    if (!m_dragged && std::abs(x - m_from) < slack)
        return;
    m_dragged = true;
    const double share =
        double(x - m_from) / std::max(1, width()) * (event->modifiers() & Qt::ShiftModifier ? fine : 1);
    m_at = std::clamp(m_at + share * (maximum() - minimum()), double(minimum()), double(maximum()));
    m_from = x;
    setValue(static_cast<int>(std::lround(m_at)));
}

void ValueBar::mouseReleaseEvent(QMouseEvent*) {
    const bool click = isSliderDown() && !m_dragged;
    setSliderDown(false);
    if (click)
        Q_EMIT clicked();
}

void ValueBar::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        Q_EMIT clicked();
    else
        QSlider::keyPressEvent(event);
}

void ValueBar::wheelEvent(QWheelEvent* event) {
    event->ignore();
}

} // namespace ui
