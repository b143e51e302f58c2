#include "ui/interaction/flight.h"

#include <algorithm>
#include <QCursor>
#include <QKeyEvent>
#include <QWidget>

namespace ui {

Flight::Flight(Navigator& navigator, const Editor& editor, QWidget& canvas, QObject* parent)
    : QObject(parent), m_navigator(navigator), m_editor(editor), m_canvas(canvas) {
    connect(&navigator, &Navigator::flightChanged, this,
            [this](bool flying) { m_canvas.setCursor(flying ? Qt::BlankCursor : Qt::CrossCursor); });
}

void Flight::takeOff() {
    constexpr double crossing = 4; // seconds through the model
    const double diagonal = static_cast<double>(m_editor.snapshot().surface.tree().bounds().diagonal());
    m_warped = false;
    m_navigator.takeOff(std::max(diagonal, 1e-30) / crossing);
    m_canvas.setFocus();
    Q_EMIT hinted(tr("Flying: W A S D and Q E to move, Shift to go faster, pointer to look, wheel to set the speed, "
                     "Esc to land."));
}

void Flight::land() {
    m_navigator.land();
}

void Flight::key(const QKeyEvent& event, bool pressed) {
    if (!event.isAutoRepeat())
        m_navigator.flyKey(event.key(), pressed);
}

QPointF Flight::look(const QPointF& fromPx, const QPointF& toPx) {
    const double scale = m_canvas.devicePixelRatioF();
    const QPointF middle = QRectF(m_canvas.rect()).center() * scale, by = toPx - fromPx;
    const double leap = 0.25 * std::min(m_canvas.width(), m_canvas.height()) * scale;
    const bool refused = m_warped && by.manhattanLength() > leap;
    m_mayWarp = m_mayWarp && !refused;
    m_warped = false;
    if (!refused)
        m_navigator.look(by.x(), by.y(), std::max(1, qRound(m_canvas.height() * scale)));
    constexpr int border = 60;
    const QRectF inner = QRectF(m_canvas.rect()).adjusted(border, border, -border, -border);
    if (!m_mayWarp || !inner.isValid() || inner.contains(toPx / scale))
        return toPx;
    QCursor::setPos(m_canvas.mapToGlobal((middle / scale).toPoint()));
    m_warped = true;
    return middle;
}

void Flight::accelerate(double steps) {
    Q_EMIT hinted(tr("Flying at %1 units per second").arg(m_navigator.accelerate(steps), 0, 'g', 3));
}

} // namespace ui
