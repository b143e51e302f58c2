#include "ui/interaction/picker.h"

#include "ui/interaction/contact.h"

#include <QKeyEvent>
#include <QLineF>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWidget>
#include <utility>

namespace ui {

/// Window's pixels within which a click meets the first corner, and less than which a lasso makes no step.
constexpr double closeBy = 8, lassoStep = 2;

Picker::Picker(const Editor& editor, const ViewMotion& motion, QWidget& canvas, QObject* parent)
    : QObject(parent), m_editor(editor), m_motion(motion), m_canvas(canvas) {
    canvas.installEventFilter(this);
    connect(&motion, &ViewMotion::moved, this, &Picker::cancel); // it was drawn over another picture
}

void Picker::begin(Owner owner) {
    end();
    m_owner = std::move(owner);
    m_on = true;
    m_canvas.update();
}

void Picker::end() {
    cancel();
    if (std::exchange(m_on, false))
        std::exchange(m_owner, {}).ended();
    m_canvas.update();
}

bool Picker::cancel() {
    m_held = false;
    if (m_outline.empty())
        return false;
    m_outline.clear();
    m_canvas.update();
    return true;
}

// --- gestures ---

bool Picker::press(const QPointF& pixel, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    if (button != Qt::LeftButton) // the view is about to move
        return false;
    if (m_outline.empty()) {
        m_modifiers = modifiers;
        m_camera = m_motion.camera();
    }
    if (m_owner.shape == PickShape::Place) {
        pickPlace(pixel);
    } else if (m_owner.shape == PickShape::Polygon) {
        addCorner(pixel);
    } else {
        m_held = true;
        m_outline = {pixel, pixel};
    }
    m_canvas.update();
    return true;
}

bool Picker::move(const QPointF& pixel) {
    if (m_outline.empty())
        return false;
    const double step = lassoStep * m_canvas.devicePixelRatioF();
    if (m_owner.shape == PickShape::Lasso && QLineF(m_outline[m_outline.size() - 2], pixel).length() >= step)
        m_outline.push_back(pixel);
    else
        m_outline.back() = pixel;
    m_canvas.update();
    return m_held;
}

bool Picker::release(const QPointF& pixel, Qt::MouseButton button) {
    if (button != Qt::LeftButton)
        return false;
    if (std::exchange(m_held, false)) {
        move(pixel);
        close();
    }
    return true;
}

void Picker::pickPlace(const QPointF& pixel) {
    const auto contact = contactAt(m_editor.snapshot().surface, m_camera, pixel);
    if (contact)
        deliver({{}, contact, m_camera, m_modifiers});
    else
        Q_EMIT hinted(tr("The surface is not there. Click on the model."));
}

void Picker::addCorner(const QPointF& pixel) {
    const bool home =
        m_outline.size() > 3 && QLineF(m_outline.front(), pixel).length() <= closeBy * m_canvas.devicePixelRatioF();
    if (home)
        return close();
    if (m_outline.empty())
        m_outline.push_back(pixel);
    m_outline.back() = pixel;
    m_outline.push_back(pixel); // which goes along with the pointer
}

/// What encloses nothing is no pick, but a slip of the hand.
void Picker::close() {
    std::vector<QPointF> corners = std::exchange(m_outline, {});
    m_canvas.update();
    if (m_owner.shape == PickShape::Polygon)
        corners.pop_back(); // the pointer
    const bool flat = m_owner.shape == PickShape::Rectangle &&
                      (corners.front().x() == corners.back().x() || corners.front().y() == corners.back().y());
    if (flat || (m_owner.shape != PickShape::Rectangle && corners.size() < 3))
        Q_EMIT hinted(m_owner.shape == PickShape::Polygon ? tr("Click three corners at least, then press Enter.")
                                                          : tr("Hold the button and draw around what is wanted."));
    else
        deliver({std::move(corners), {}, m_camera, m_modifiers});
}

/// Who gets it may end this, or begin another.
void Picker::deliver(const Pick& pick) {
    const auto then = m_owner.then;
    if (m_owner.once)
        end();
    then(pick);
}

// --- events ---

bool Picker::eventFilter(QObject*, QEvent* event) {
    if (!m_on)
        return false;
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
    case QEvent::KeyPress:
        return key(static_cast<QKeyEvent&>(*event));
    case QEvent::Resize: // the picture is another one
        cancel();
        return false;
    default:
        return false;
    }
}

bool Picker::mouse(const QMouseEvent& event) {
    const QPointF pixel = event.position() * m_canvas.devicePixelRatioF();
    if (event.modifiers().testFlag(Qt::AltModifier) && !m_held) // turns the view
        return false;
    if (event.type() == QEvent::MouseMove)
        return move(pixel);
    if (event.type() == QEvent::MouseButtonRelease)
        return release(pixel, event.button());
    const bool again = event.type() == QEvent::MouseButtonDblClick && event.button() == Qt::LeftButton;
    if (again && m_owner.shape == PickShape::Polygon && !m_outline.empty()) {
        close(); // its first click has added the corner
        return true;
    }
    return press(pixel, event.button(), event.modifiers());
}

bool Picker::tablet(QTabletEvent& event) {
    const QPointF pixel = event.position() * m_canvas.devicePixelRatioF();
    if (event.modifiers().testFlag(Qt::AltModifier) && !m_held)
        return false;
    const bool taken = event.type() == QEvent::TabletMove      ? move(pixel)
                       : event.type() == QEvent::TabletRelease ? release(pixel, event.button())
                                                               : press(pixel, event.button(), event.modifiers());
    if (taken)
        event.accept();
    return taken;
}

bool Picker::key(const QKeyEvent& event) {
    if (m_owner.shape != PickShape::Polygon || m_outline.empty())
        return false;
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        close();
        return true;
    }
    if (event.key() != Qt::Key_Backspace)
        return false;
    if (m_outline.size() <= 2)
        return cancel();
    m_outline.erase(m_outline.end() - 2);
    m_canvas.update();
    return true;
}

} // namespace ui
