#include "ui/interaction/pointer_router.h"

#include "ui/interaction/scene_pick.h"

#include <algorithm>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <QWidget>
#include <utility>

namespace ui {

PointerRouter::PointerRouter(const Parts& parts, QWidget& canvas, QObject* parent)
    : QObject(parent), m_parts(parts), m_canvas(canvas) {
    canvas.setMouseTracking(true);
    canvas.setTabletTracking(true);
    canvas.setFocusPolicy(Qt::StrongFocus);
    canvas.setCursor(Qt::CrossCursor);
    canvas.installEventFilter(this);
}

std::optional<BrushContact> PointerRouter::contactAt(const QPointF& pixel) const {
    return seenAt(m_parts.editor.snapshot(), m_parts.motion.camera(), pixel).contact;
}

std::optional<BrushContact> PointerRouter::contactUnderPointer() const {
    return m_inside ? contactAt(m_pointer.pixel) : std::nullopt;
}

void PointerRouter::followCursor() {
    const bool still = !m_parts.motion.navigator().inTransition() && !m_parts.flight.on();
    const bool brush = m_gesture == Gesture::None || m_gesture == Gesture::Sculpt;
    m_parts.cursor.follow(m_parts.sizing.dragging() ? m_sized : m_pointer, m_inside && still && brush);
}

bool PointerRouter::cancel() {
    if (m_gesture == Gesture::Sculpt) {
        m_gesture = Gesture::None;
        m_parts.strokes.cancel();
        return true;
    }
    if (m_parts.sizing.dragging()) {
        m_parts.sizing.endDrag(false);
        return true;
    }
    if (m_parts.flight.on()) {
        m_parts.flight.land();
        return true;
    }
    return false;
}

void PointerRouter::takeOff() {
    if (m_gesture == Gesture::None && !m_parts.flight.on())
        m_parts.flight.takeOff();
}

void PointerRouter::pickPivot() {
    pickPivotAt(contactUnderPointer());
}

void PointerRouter::pickPivotAt(const std::optional<BrushContact>& contact) {
    m_parts.motion.navigator().setPivot(contact ? std::optional(contact->position) : std::nullopt);
    Q_EMIT hinted(contact ? tr("The view now turns about this place.")
                          : tr("The view now turns about the middle of the picture."));
    m_canvas.update();
}

// --- gestures ---

void PointerRouter::press(const Pointer& pointer) {
    ++m_inputs;
    if (m_gesture != Gesture::None)
        return;
    m_pointer = pointer;
    if (m_parts.sizing.dragging())
        return m_parts.sizing.endDrag(pointer.button != Qt::RightButton);
    if (m_parts.flight.on())
        return m_parts.flight.land();
    m_parts.motion.navigator().finish();
    m_button = pointer.button;
    const bool left = pointer.button == Qt::LeftButton && !pointer.modifiers.testFlag(Qt::AltModifier);
    const Seen seen = left && m_parts.editor.ready()
                          ? seenAt(m_parts.editor.snapshot(), m_parts.motion.camera(), pointer.pixel)
                          : Seen();
    if (seen.other)
        Q_EMIT modelPicked(QString::fromStdString(seen.other->name));
    else if (seen.contact)
        touch(pointer, *seen.contact);
    else if (pointer.button == Qt::LeftButton || pointer.button == Qt::RightButton)
        m_gesture = Gesture::Orbit;
    else if (pointer.button == Qt::MiddleButton)
        m_gesture = Gesture::Pan;
    followCursor();
}

void PointerRouter::touch(const Pointer& pointer, const BrushContact& contact) {
    const bool smoothing = pointer.modifiers.testFlag(Qt::ShiftModifier);
    if (m_parts.settings.toolRow().needs.source && !smoothing) {
        if (pointer.modifiers.testFlag(Qt::ControlModifier))
            return m_parts.source.choose(contact.position);
        if (!m_parts.source.place()) {
            Q_EMIT hinted(tr("First Ctrl+click on the model to choose where to copy from."));
            return;
        }
    }
    m_gesture = Gesture::Sculpt;
    m_parts.strokes.begin(pointer, contact, m_inputs);
    Q_EMIT touched(smoothing ? QString::fromStdString(m_parts.settings.shiftTool)
                             : QString(m_parts.settings.toolRow().id));
}

void PointerRouter::move(const Pointer& pointer) {
    ++m_inputs;
    m_inside = true;
    const QPointF from = std::exchange(m_pointer, pointer).pixel;
    if (m_parts.flight.on()) {
        m_pointer.pixel = m_parts.flight.look(from, pointer.pixel);
        return;
    }
    if (m_gesture == Gesture::Orbit)
        return m_parts.motion.orbit(from, pointer.pixel);
    if (m_gesture == Gesture::Pan)
        return m_parts.motion.pan(pointer.pixel - from);
    if (m_parts.sizing.dragging() && m_gesture == Gesture::None) {
        m_sizedByMove = true;
        return m_parts.sizing.drag(pointer.pixel.x() - from.x());
    }
    if (m_gesture == Gesture::Sculpt)
        m_parts.strokes.add(pointer, m_inputs);
    followCursor();
}

void PointerRouter::release(const Pointer& pointer) {
    ++m_inputs;
    m_pointer = pointer;
    if (pointer.button != m_button)
        return;
    const Gesture ended = std::exchange(m_gesture, Gesture::None);
    if (ended == Gesture::Sculpt)
        m_parts.strokes.end();
    if (ended != Gesture::None)
        Q_EMIT pictureChanged(false);
}

// --- events ---

bool PointerRouter::eventFilter(QObject*, QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        return mouse(static_cast<QMouseEvent&>(*event));
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
        return tablet(static_cast<QTabletEvent&>(*event));
    case QEvent::Wheel:
        return wheel(static_cast<QWheelEvent&>(*event));
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
        return key(static_cast<QKeyEvent&>(*event), event->type() == QEvent::KeyPress);
    case QEvent::ShortcutOverride: // while flying, letters are no shortcuts, nor digits while a number is wanted
        if (m_parts.flight.takes(static_cast<QKeyEvent&>(*event).key()) ||
            (m_parts.sizing.dragging() && BrushSizing::types(static_cast<QKeyEvent&>(*event))))
            event->accept();
        return false;
    case QEvent::Enter:
        m_canvas.setFocus(Qt::MouseFocusReason);
        return false;
    case QEvent::Leave:
    case QEvent::FocusOut:
        leave(event->type() == QEvent::FocusOut);
        return false;
    case QEvent::Resize:
    case QEvent::Show:
        Q_EMIT pictureChanged(false);
        return false;
    default:
        return false;
    }
}

/// Is a press of this button and these keys about the view, wherever it is?
static bool turnsView(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    return button == Qt::RightButton || (button == Qt::LeftButton && modifiers.testFlag(Qt::AltModifier));
}

bool PointerRouter::mouse(const QMouseEvent& event) {
    const double scale = m_canvas.devicePixelRatioF();
    const Pointer pointer{event.position() * scale, event.button(), event.modifiers(), 1};
    if (event.type() == QEvent::MouseMove)
        move(pointer);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(pointer);
    else if (event.type() == QEvent::MouseButtonDblClick && turnsView(pointer.button, pointer.modifiers))
        pickPivotAt(contactAt(pointer.pixel));
    else
        press(pointer);
    return true;
}

bool PointerRouter::tablet(QTabletEvent& event) {
    const double scale = m_canvas.devicePixelRatioF();
    const float pressure = std::clamp(static_cast<float>(event.pressure()), 0.0f, 1.0f);
    const bool eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
    const Pointer pointer{event.position() * scale, event.button(), event.modifiers(), pressure, eraser};
    if (event.type() == QEvent::TabletMove)
        move(pointer);
    else if (event.type() == QEvent::TabletRelease)
        release(pointer);
    else
        press(pointer);
    event.accept();
    return true;
}

bool PointerRouter::wheel(QWheelEvent& event) {
    const double steps = event.angleDelta().y() / 120.0;
    event.accept();
    if (m_parts.flight.on()) {
        m_parts.flight.accelerate(steps);
        return true;
    }
    Navigator& navigator = m_parts.motion.navigator();
    navigator.finish();
    if (m_gesture == Gesture::Sculpt)
        return true;
    const auto under = contactAt(event.position() * m_canvas.devicePixelRatioF());
    navigator.zoom(steps, under ? under->position : navigator.view().target);
    Q_EMIT pictureChanged(true);
    return true;
}

bool PointerRouter::key(const QKeyEvent& event, bool pressed) {
    if (m_parts.flight.takes(event.key())) {
        m_parts.flight.key(event, pressed);
        return true;
    }
    if (m_parts.sizing.dragging() && BrushSizing::types(event)) {
        if (pressed && m_parts.sizing.type(event))
            m_parts.sizing.endDrag(true);
        followCursor();
        return true;
    }
    const Qt::KeyboardModifiers changes = event.key() == Qt::Key_Control ? Qt::ControlModifier
                                          : event.key() == Qt::Key_Shift ? Qt::ShiftModifier
                                                                         : Qt::NoModifier;
    m_pointer.modifiers = pressed ? event.modifiers() | changes : event.modifiers() & ~changes;
    if (event.key() == Qt::Key_F && !event.isAutoRepeat())
        holdF(event, pressed);
    followCursor();
    return false;
}

/// Held while the pointer moves, or tapped: then the pointer is free until a click or another tap.
void PointerRouter::holdF(const QKeyEvent& event, bool pressed) {
    BrushSizing& sizing = m_parts.sizing;
    if (sizing.dragging() && (pressed || m_sizedByMove))
        return sizing.endDrag(true);
    if (!pressed || m_gesture != Gesture::None)
        return;
    m_sized = m_pointer;
    m_sizedByMove = false;
    if (event.modifiers() == Qt::NoModifier)
        sizing.beginDrag(BrushSizing::Value::Radius);
    else if (event.modifiers() == Qt::ShiftModifier)
        sizing.beginDrag(BrushSizing::Value::Strength);
}

void PointerRouter::leave(bool unfocused) {
    m_inside = false;
    if (m_parts.sizing.dragging())
        m_parts.sizing.endDrag(true);
    if (m_parts.flight.on() && unfocused)
        m_parts.flight.land();
    followCursor();
}

} // namespace ui
