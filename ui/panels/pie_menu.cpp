#include "ui/panels/pie_menu.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace ui {

constexpr double across = 120, along = 100; // pixels, of the plates' middles from the pie's: plates are wide
constexpr double dead = 22;                 // where nothing is chosen
constexpr QSizeF plate(128, 26);

PieMenu::PieMenu(QWidget& canvas, const QPoint& at, const QList<QAction*>& actions)
    : QWidget(&canvas), m_actions(actions.mid(0, most)) {
    setObjectName("pie");
    setAttribute(Qt::WA_DeleteOnClose);
    setMouseTracking(true);
    setCursor(Qt::ArrowCursor);
    setGeometry(canvas.rect());
    const auto inside = [](int place, double reach, int size) {
        const int most = static_cast<int>(std::ceil(reach));
        return 2 * most < size ? std::clamp(place, most, size - most) : size / 2;
    };
    m_middle = {inside(at.x(), across + plate.width() / 2, width()),
                inside(at.y(), along + plate.height() / 2, height())};
    show();
    raise();
    setFocus(Qt::PopupFocusReason);
}

/// The first is upwards, the others go round clockwise.
QPointF PieMenu::direction(qsizetype which) const {
    const double angle = 2 * std::numbers::pi * double(which) / double(m_actions.size());
    return {across * std::sin(angle), -along * std::cos(angle)};
}

qsizetype PieMenu::actionAt(const QPointF& at) const {
    const QPointF from = at - m_middle;
    if (std::hypot(from.x(), from.y()) < dead)
        return -1;
    qsizetype best = -1;
    double nearest = 0;
    for (qsizetype i = 0; i < m_actions.size(); ++i)
        if (const double each = QPointF::dotProduct(from, direction(i)); best < 0 || each > nearest)
            best = i, nearest = each;
    return best;
}

QRectF PieMenu::plateOf(qsizetype which) const {
    QRectF out({}, plate);
    out.moveCenter(m_middle + direction(which));
    return out;
}

/// No key is a shortcut meanwhile, Esc neither.
bool PieMenu::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride)
        event->accept();
    return QWidget::event(event);
}

void PieMenu::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 3));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawEllipse(QPointF(m_middle), dead / 2, dead / 2);
    for (qsizetype i = 0; i < m_actions.size(); ++i) {
        const bool under = i == m_under;
        painter.setPen(QPen(palette().color(under ? QPalette::Highlight : QPalette::Base), 1));
        painter.setBrush(palette().color(under ? QPalette::Highlight : QPalette::Window));
        painter.drawRoundedRect(plateOf(i), 6, 6);
        painter.setPen(palette().color(under ? QPalette::HighlightedText : QPalette::WindowText));
        painter.drawText(plateOf(i), Qt::AlignCenter, m_actions[i]->text().remove('&'));
    }
}

void PieMenu::take(qsizetype which) {
    if (std::exchange(m_done, true))
        return;
    QAction* const action = which >= 0 ? m_actions[which] : nullptr;
    if (hasFocus())
        parentWidget()->setFocus();
    close();
    if (action)
        action->trigger();
}

void PieMenu::mouseMoveEvent(QMouseEvent* event) {
    m_under = actionAt(event->position());
    update();
}

void PieMenu::mousePressEvent(QMouseEvent* event) {
    take(event->button() == Qt::LeftButton ? actionAt(event->position()) : -1);
}

void PieMenu::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        take(-1);
}

void PieMenu::keyReleaseEvent(QKeyEvent* event) {
    if (!event->isAutoRepeat() && m_under >= 0)
        take(m_under);
}

void PieMenu::focusOutEvent(QFocusEvent*) {
    take(-1);
}

} // namespace ui
