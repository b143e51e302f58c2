#include "ui/panels/view_gizmo.h"

#include "ui/theme/theme.h"

#include <algorithm>
#include <QApplication>
#include <QMouseEvent>
#include <QPainter>

namespace ui {

constexpr double radius = 10; // of an end
constexpr double arm = ViewGizmo::side / 2.0 - radius - 1;

ViewGizmo::ViewGizmo(QWidget& canvas) : QWidget(&canvas), m_canvas(canvas) {
    setObjectName("view-gizmo");
    setAccessibleName(tr("Directions of view"));
    setToolTip(tr("Click an axis to look along it, again for the other side; drag to turn the view"));
    setCursor(Qt::ArrowCursor);
    setMouseTracking(true);
    resize(side, side);
    canvas.installEventFilter(this);
    fit();
}

void ViewGizmo::setAxes(const base::Vec3d& right, const base::Vec3d& up, const base::Vec3d& toEye) {
    m_right = right, m_up = up, m_toEye = toEye;
    update();
}

void ViewGizmo::setWanted(bool wanted) {
    m_wanted = wanted;
    fit();
}

void ViewGizmo::fit() {
    constexpr int margin = 10;
    move(m_canvas.width() - side - margin, margin);
    setVisible(m_wanted && std::min(m_canvas.width(), m_canvas.height()) > 3 * side);
}

bool ViewGizmo::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::Resize)
        fit();
    return false;
}

// --- geometry ---

base::Vec3d ViewGizmo::seen(int axis, bool positive) const {
    base::Vec3d direction;
    direction[static_cast<std::size_t>(axis)] = positive ? 1 : -1;
    return {dot(direction, m_right), dot(direction, m_up), dot(direction, m_toEye)};
}

QPointF ViewGizmo::place(int axis, bool positive) const {
    const base::Vec3d at = seen(axis, positive);
    return QPointF(0.5 * side + arm * at.x, 0.5 * side - arm * at.y);
}

std::array<ViewGizmo::End, 6> ViewGizmo::ends() const {
    std::array<End, 6> out;
    for (std::size_t k = 0; k < out.size(); ++k) {
        const int axis = static_cast<int>(k / 2);
        out[k] = {axis, k % 2 == 0, seen(axis, k % 2 == 0).z};
    }
    std::ranges::stable_sort(out, {}, &End::depth);
    return out;
}

std::optional<ViewGizmo::End> ViewGizmo::endAt(const QPointF& at) const {
    const auto all = ends();
    for (auto end = all.rbegin(); end != all.rend(); ++end) // the nearest is on top
        if (QLineF(place(end->axis, end->positive), at).length() <= radius + 1)
            return *end;
    return {};
}

// --- painting ---

static void paintEnd(QPainter& painter, const QPointF& at, int axis, bool positive, bool under) {
    const QColor colour = under ? axisColour(axis).lighter(135) : axisColour(axis);
    QColor faint = colour;
    faint.setAlpha(90);
    painter.setPen(QPen(colour, 1.4));
    painter.setBrush(positive ? colour : faint);
    painter.drawEllipse(at, radius, radius);
    if (!positive && !under)
        return;
    QFont font = painter.font();
    font.setBold(true);
    font.setPixelSize(11);
    painter.setFont(font);
    painter.setPen(positive ? QColor(20, 20, 24) : Qt::white);
    const QRectF box(at.x() - 2 * radius, at.y() - radius, 4 * radius, 2 * radius);
    painter.drawText(box, Qt::AlignCenter, (positive ? "" : "−") + QString("XYZ"[axis]));
}

void ViewGizmo::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle(0.5 * side, 0.5 * side);
    if (underMouse()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(255, 255, 255, 26));
        painter.drawEllipse(middle, middle.x(), middle.y());
    }
    for (const End& end : ends()) {
        const QPointF at = place(end.axis, end.positive);
        if (end.positive) {
            painter.setPen(QPen(axisColour(end.axis), 2.2));
            painter.drawLine(middle, at);
        }
        paintEnd(painter, at, end.axis, end.positive, m_under == end);
    }
}

// --- the hand ---

void ViewGizmo::mousePressEvent(QMouseEvent* event) {
    m_pressed = event->position();
    m_dragging = false;
}

void ViewGizmo::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        m_under = endAt(at);
        return update();
    }
    if (!m_dragging && (at - m_pressed).manhattanLength() < QApplication::startDragDistance())
        return;
    m_dragging = true;
    Q_EMIT dragged(at - m_pressed);
    m_pressed = at;
}

void ViewGizmo::mouseReleaseEvent(QMouseEvent* event) {
    if (std::exchange(m_dragging, false) || event->button() != Qt::LeftButton)
        return;
    const std::optional<End> end = endAt(event->position());
    if (!end)
        return;
    constexpr double straight = 1 - 1e-6;
    const bool there = seen(end->axis, end->positive).z > straight;
    base::Vec3d out;
    out[static_cast<std::size_t>(end->axis)] = end->positive != there ? 1 : -1;
    Q_EMIT sideWanted(out);
}

void ViewGizmo::leaveEvent(QEvent*) {
    m_under.reset();
    update();
}

} // namespace ui
