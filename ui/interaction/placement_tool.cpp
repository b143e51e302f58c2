#include "ui/interaction/placement_tool.h"

#include "ui/overlay/placement_overlay.h"

#include <QPointerEvent>
#include <QWidget>

namespace ui {

PlacementTool::PlacementTool(const ViewMotion& motion, QWidget& canvas, QObject* parent)
    : QObject(parent), m_motion(motion), m_canvas(canvas) {
    canvas.installEventFilter(this);
}

void PlacementTool::begin(const base::Vec3d& middle) {
    m_on = true;
    m_middle = middle;
    m_placement = {};
    m_drag.reset();
    m_canvas.update();
}

void PlacementTool::end() {
    m_on = false;
    m_drag.reset();
    m_under.reset();
    m_canvas.update();
}

void PlacementTool::set(const Placement& placement) {
    m_placement = placement;
    m_canvas.update();
}

bool PlacementTool::cancel() {
    if (!m_drag)
        return false;
    m_placement = m_drag->before;
    m_drag.reset();
    m_canvas.update();
    Q_EMIT changed();
    return true;
}

double PlacementTool::lengthPx() const {
    constexpr double length = 80;
    return length * m_canvas.devicePixelRatioF();
}

std::optional<Handle> PlacementTool::under(const QPointF& pixel) const {
    constexpr double reach = 9;
    return handleAt(m_motion.camera(), middle(), lengthPx(), pixel.x(), pixel.y(),
                    reach * m_canvas.devicePixelRatioF());
}

void PlacementTool::paint(QPainter& painter, const render::Camera& seen) const {
    if (!m_on)
        return;
    const std::vector<HandleShape> shapes = handleShapes(seen, middle(), lengthPx());
    paintHandles(painter, shapes, m_drag ? std::optional(m_drag->handle) : m_under, seen, m_canvas.devicePixelRatioF());
}

bool PlacementTool::eventFilter(QObject*, QEvent* event) {
    if (!m_on || !event->isPointerEvent())
        return false;
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::TabletPress:
    case QEvent::MouseMove:
    case QEvent::TabletMove:
    case QEvent::MouseButtonRelease:
    case QEvent::TabletRelease: {
        const auto& pointer = static_cast<QSinglePointEvent&>(*event);
        const bool taken = hand(event->type(), pointer.position(), pointer.button(), pointer.modifiers());
        if (taken)
            event->accept(); // no mouse event of the same
        return taken;
    }
    default:
        return false;
    }
}

bool PlacementTool::hand(QEvent::Type what, const QPointF& at, Qt::MouseButton button,
                         Qt::KeyboardModifiers modifiers) {
    const QPointF pixel = at * m_canvas.devicePixelRatioF();
    if (what == QEvent::MouseMove || what == QEvent::TabletMove) {
        if (!m_drag) {
            const std::optional<Handle> before = std::exchange(m_under, under(pixel));
            if (before != m_under)
                m_canvas.update();
            return false;
        }
        m_placement =
            dragged(*m_drag, m_motion.camera(), pixel.x(), pixel.y(), modifiers.testFlag(Qt::ControlModifier));
        m_canvas.update();
        Q_EMIT changed();
        return true;
    }
    if (button != Qt::LeftButton)
        return false;
    if (what == QEvent::MouseButtonRelease || what == QEvent::TabletRelease) {
        if (!std::exchange(m_drag, std::nullopt))
            return false;
        Q_EMIT changed();
        return true;
    }
    const std::optional<Handle> handle = under(pixel);
    if (!handle)
        return false;
    m_drag = HandleDrag{*handle, m_placement, middle(), pixel.x(), pixel.y()};
    return true;
}

} // namespace ui
