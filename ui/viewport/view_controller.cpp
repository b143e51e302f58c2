#include "ui/viewport/view_controller.h"

#include "core/surface/rays/intersect.h"
#include "ui/viewport/annotation_overlay.h"
#include "ui/viewport/pivot_overlay.h"
#include "ui/viewport/symmetry_overlay.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <QWheelEvent>
#include <QWidget>

namespace ui {

using base::Vec3d;

ViewController::ViewController(Editor& editor, Settings& settings, Viewport& viewport, QObject* parent)
    : QObject(parent), m_editor(editor), m_settings(settings), m_viewport(viewport) {
    QWidget* widget = viewport.widget();
    widget->setMouseTracking(true);
    widget->setTabletTracking(true);
    widget->setFocusPolicy(Qt::StrongFocus);
    widget->setCursor(Qt::CrossCursor);
    widget->installEventFilter(this);
    viewport.paintOverlay = [this](QPainter& painter) { paintOverlay(painter); };
    connect(&editor, &Editor::changed, this, &ViewController::followModel);
    connect(&m_navigator, &Navigator::moved, this, &ViewController::viewMoved);
    connect(&m_navigator, &Navigator::flightChanged, this, [this](bool flying) {
        m_viewport.widget()->setCursor(flying ? Qt::BlankCursor : Qt::CrossCursor);
        Q_EMIT viewChanged();
    });
    m_navigator.chooseStyle(navigation(settings.navigation));
}

ViewController::~ViewController() = default;

void ViewController::refresh(bool moving) {
    Frame frame;
    frame.model = m_editor.snapshot().surface.tree();
    frame.camera = shownCamera();
    frame.moving = moving;
    frame.options = look();
    frame.options.colours = m_colours;
    frame.truth = truth();
    frame.input = std::max(m_editor.snapshot().input, m_viewInput);
    frame.options.definition = m_editor.snapshot().surface.definition();
    frame.options.splatScale = m_editor.snapshot().splatScale;
    m_viewport.show(frame);
    updateCursor();
}

// --- the brush ---

/// From where no plane cuts it.
static base::Rayf narrowed(const base::Rayd& ray, const base::RayPart& part) {
    return {base::cast<float>(ray.at(part.first)), base::normalized(base::cast<float>(ray.direction))};
}

std::optional<BrushContact> ViewController::contactAt(const QPointF& place) const {
    const render::Camera now = camera();
    const base::Rayd ray = now.ray(place.x(), place.y());
    const base::RayPart part = now.uncut(ray);
    const surface::Surface& surface = m_editor.snapshot().surface;
    if (surface.tree().empty() || part.empty())
        return {};
    const surface::RayHit<float> hit = surface::intersect(surface, narrowed(ray, part));
    if (!hit.hit || static_cast<double>(hit.t) + part.first > part.second)
        return {};
    return BrushContact{base::cast<double>(hit.position), base::cast<double>(hit.normal)};
}

double ViewController::pixelsAt(const Vec3d& p) const {
    const render::Camera now = camera();
    return now.pixelsPerUnit(std::max(now.project(p).z, 1e-12 * view().distance));
}

double ViewController::worldRadius(const Vec3d& contact) const {
    if (m_settings.radiusUnit == RadiusUnit::Model)
        return m_settings.radiusModel;
    return m_settings.radiusPx * m_viewport.widget()->devicePixelRatioF() / pixelsAt(contact);
}

void ViewController::updateCursor() {
    m_cursor.pointer = m_pointer.place;
    m_cursor.contact.reset();
    m_cursor.radiusPx = 0;
    const sculpt::StrokeSettings choice = m_settings.choice(m_settings.toolRow());
    m_cursor.inverted = choice.invert != m_pointer.modifiers.testFlag(Qt::ControlModifier);
    m_cursor.label.clear();
    if (m_drag && m_drag->what == Dragged::Radius)
        m_cursor.label = tr("Radius %1").arg(draggedRadius(), 0, 'g', 3);
    else if (m_drag)
        m_cursor.label = tr("Strength %1").arg(double(choice.strength), 0, 'f', 2);
    const bool still = !m_navigator.underWay() && !m_navigator.flying();
    if (m_inside && still && (m_gesture == Gesture::None || m_gesture == Gesture::Sculpt)) {
        m_cursor.contact = contactAt(m_pointer.place);
        if (m_cursor.contact)
            m_cursor.radius = worldRadius(m_cursor.contact->position);
        else if (m_settings.radiusUnit == RadiusUnit::Pixels)
            m_cursor.radiusPx = m_settings.radiusPx * m_viewport.widget()->devicePixelRatioF();
        else
            m_cursor.radiusPx = m_settings.radiusModel * pixelsAt(view().target);
    }
    m_viewport.widget()->update();
}

void ViewController::paintOverlay(QPainter& painter) const {
    const double scale = 1 / m_viewport.widget()->devicePixelRatioF();
    painter.save();
    painter.scale(scale, scale);
    const Snapshot& now = m_editor.snapshot();
    const render::Camera seen = shownCamera();
    if (beneath)
        beneath(painter, seen);
    if (m_sections.size() == seen.clips.all().size())
        paintSections(painter, m_sections, seen, 1.6 / scale);
    if (view().pivot || m_gesture == Gesture::Orbit)
        paintPivot(painter, view().turningPoint(), seen, m_gesture == Gesture::Orbit);
    if (m_settings.symmetry != sculpt::Symmetry{} && !now.surface.tree().empty())
        paint(painter, SymmetryOverlay{m_settings.symmetry, now.origin, now.surface.tree().bounds(), m_cursor.contact},
              seen);
    if (m_source && sculpt::hasSource(m_settings.toolRow())) {
        const bool going = m_gesture == Gesture::Sculpt && m_cursor.contact;
        paintSource(painter, *m_source + (going ? m_cursor.contact->position - m_strokeStart : Vec3d{}), seen);
    }
    paint(painter, render::annotate(m_settings.annotated, seen, m_scale, m_settings.backdrop, look().pixelScale));
    if (!m_navigator.flying())
        paint(painter, m_cursor, seen);
    painter.restore();
}

void ViewController::scaleRadius(double factor) {
    if (m_settings.radiusUnit == RadiusUnit::Pixels)
        m_settings.radiusPx = std::clamp(m_settings.radiusPx * factor, Settings::minRadiusPx, Settings::maxRadiusPx);
    else
        m_settings.radiusModel = std::clamp(m_settings.radiusModel * factor, 1e-30, 1e30);
    updateCursor();
    Q_EMIT brushChanged();
}

void ViewController::shiftStrength(double by) {
    sculpt::StrokeSettings& tool = m_settings.edit(m_settings.toolRow());
    tool.strength = static_cast<float>(std::clamp(double(tool.strength) + by, 0.0, 1.0));
    updateCursor();
    Q_EMIT brushChanged();
}

/// Half the range for 150 pixels.
void ViewController::dragValue(double dx) {
    if (m_drag->what == Dragged::Radius)
        scaleRadius(std::exp(dx / 150));
    else
        shiftStrength(dx / 300);
}

double& ViewController::draggedRadius() {
    return m_settings.radiusUnit == RadiusUnit::Pixels ? m_settings.radiusPx : m_settings.radiusModel;
}

void ViewController::endDrag(bool keep) {
    const ValueDrag drag = *std::exchange(m_drag, std::nullopt);
    if (!keep && drag.what == Dragged::Radius)
        draggedRadius() = drag.before;
    else if (!keep)
        m_settings.edit(m_settings.toolRow()).strength = static_cast<float>(drag.before);
    updateCursor();
    Q_EMIT brushChanged();
}

// --- strokes ---

void ViewController::beginStroke(const Pointer& pointer, const BrushContact& contact) {
    const bool smoothing = pointer.modifiers.testFlag(Qt::ShiftModifier);
    const sculpt::ToolRow& row = smoothing ? sculpt::tool(m_settings.shiftTool) : m_settings.toolRow();
    const bool flip = pointer.modifiers.testFlag(Qt::ControlModifier);
    sculpt::StrokeSettings settings =
        strokeSettings(m_settings, row, static_cast<float>(worldRadius(contact.position)), flip);
    if (sculpt::hasSource(row)) {
        const Vec3d away = *m_source - contact.position;
        settings.parameters["x"] = away.x, settings.parameters["y"] = away.y, settings.parameters["z"] = away.z;
    }
    m_strokeStart = contact.position;
    m_editor.beginStroke(settings);
    m_gesture = Gesture::Sculpt;
    m_strokeClock.start();
    addSample(pointer);
}

void ViewController::addSample(const Pointer& pointer) {
    const render::Camera now = camera();
    const base::Rayd ray = now.ray(pointer.place.x(), pointer.place.y());
    const base::RayPart part = now.uncut(ray);
    if (part.empty() || (std::isfinite(part.second) && !contactAt(pointer.place)))
        return; // nothing that is shown
    sculpt::StrokeSample sample;
    sample.ray = narrowed(ray, part);
    sample.pressure = pointer.pressure;
    sample.seconds = static_cast<float>(static_cast<double>(m_strokeClock.nsecsElapsed()) * 1e-9);
    m_editor.addSample(sample, m_inputs);
}

void ViewController::chooseSource(const std::optional<Vec3d>& place) {
    m_source = place;
    const Vec3d shown = place.value_or(Vec3d{}) + m_editor.snapshot().origin;
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    Q_EMIT sourceChanged(place ? QString("(%1, %2, %3)").arg(number(shown.x), number(shown.y), number(shown.z))
                               : QString());
}

bool ViewController::cancel() {
    if (m_gesture == Gesture::Sculpt) {
        m_gesture = Gesture::None;
        m_editor.cancelStroke();
        return true;
    }
    if (m_drag) {
        endDrag(false);
        return true;
    }
    if (m_navigator.flying()) {
        m_navigator.land();
        return true;
    }
    return false;
}

// --- gestures ---

void ViewController::press(const Pointer& pointer) {
    ++m_inputs;
    if (m_gesture != Gesture::None)
        return;
    m_pointer = pointer;
    if (m_navigator.flying())
        return m_navigator.land();
    m_navigator.finish();
    m_button = pointer.button;
    const bool left = pointer.button == Qt::LeftButton && !pointer.modifiers.testFlag(Qt::AltModifier);
    const auto contact = left && m_editor.ready() ? contactAt(pointer.place) : std::nullopt;
    const bool copies = sculpt::hasSource(m_settings.toolRow()) && !pointer.modifiers.testFlag(Qt::ShiftModifier);
    if (contact && copies && pointer.modifiers.testFlag(Qt::ControlModifier))
        chooseSource(contact->position);
    else if (contact && copies && !m_source)
        Q_EMIT hinted(tr("Ctrl+click on the model first: where to copy from."));
    else if (contact)
        beginStroke(pointer, *contact);
    else if (pointer.button == Qt::LeftButton || pointer.button == Qt::RightButton)
        m_gesture = Gesture::Orbit;
    else if (pointer.button == Qt::MiddleButton)
        m_gesture = Gesture::Pan;
    updateCursor();
}

void ViewController::move(const Pointer& pointer) {
    ++m_inputs;
    m_inside = true;
    if (m_navigator.flying())
        return lookAround(pointer);
    if (m_gesture == Gesture::Orbit || m_gesture == Gesture::Pan)
        return turn(pointer);
    const QPointF by = pointer.place - m_pointer.place;
    m_pointer = pointer;
    if (m_drag && m_gesture == Gesture::None)
        return dragValue(by.x());
    if (m_gesture == Gesture::Sculpt)
        addSample(pointer);
    updateCursor();
}

void ViewController::release(const Pointer& pointer) {
    ++m_inputs;
    m_pointer = pointer;
    if (pointer.button != m_button)
        return;
    const Gesture ended = std::exchange(m_gesture, Gesture::None);
    if (ended == Gesture::Sculpt)
        m_editor.endStroke();
    if (ended != Gesture::None)
        refresh();
}

// --- events ---

bool ViewController::eventFilter(QObject*, QEvent* event) {
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
    case QEvent::ShortcutOverride: // while flying, letters are no shortcuts
        if (m_navigator.flying() && Navigator::isFlyKey(static_cast<QKeyEvent&>(*event).key()))
            event->accept();
        return false;
    case QEvent::Enter:
        m_viewport.widget()->setFocus(Qt::MouseFocusReason);
        return false;
    case QEvent::Leave:
    case QEvent::FocusOut:
        m_inside = false;
        if (m_drag)
            endDrag(true);
        if (m_navigator.flying() && event->type() == QEvent::FocusOut)
            m_navigator.land();
        updateCursor();
        return false;
    case QEvent::Resize:
    case QEvent::Show:
        refresh();
        return false;
    default:
        return false;
    }
}

/// Is a press of this button and these keys about the view, wherever it is?
static bool turnsView(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    return button == Qt::RightButton || (button == Qt::LeftButton && modifiers.testFlag(Qt::AltModifier));
}

bool ViewController::mouse(QMouseEvent& event) {
    const double scale = m_viewport.widget()->devicePixelRatioF();
    const Pointer pointer{event.position() * scale, event.button(), event.modifiers(), 1};
    if (event.type() == QEvent::MouseMove)
        move(pointer);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(pointer);
    else if (event.type() == QEvent::MouseButtonDblClick && turnsView(pointer.button, pointer.modifiers))
        pickPivotAt(pointer.place);
    else
        press(pointer);
    return true;
}

bool ViewController::tablet(QTabletEvent& event) {
    const double scale = m_viewport.widget()->devicePixelRatioF();
    const float pressure = std::clamp(static_cast<float>(event.pressure()), 0.0f, 1.0f);
    const Pointer pointer{event.position() * scale, event.button(), event.modifiers(), pressure};
    if (event.type() == QEvent::TabletMove)
        move(pointer);
    else if (event.type() == QEvent::TabletRelease)
        release(pointer);
    else
        press(pointer);
    event.accept();
    return true;
}

bool ViewController::wheel(QWheelEvent& event) {
    const double scale = m_viewport.widget()->devicePixelRatioF();
    const double steps = event.angleDelta().y() / 120.0;
    event.accept();
    if (m_navigator.flying()) {
        Q_EMIT hinted(tr("Flying at %1 units a second").arg(m_navigator.accelerate(steps), 0, 'g', 3));
        return true;
    }
    m_navigator.finish();
    const auto under = contactAt(event.position() * scale);
    if (m_gesture != Gesture::Sculpt) {
        m_navigator.zoom(steps, under ? under->position : view().target);
        refresh(true);
    }
    return true;
}

bool ViewController::key(QKeyEvent& event, bool pressed) {
    const auto changes = event.key() == Qt::Key_Control ? Qt::ControlModifier
                         : event.key() == Qt::Key_Shift ? Qt::ShiftModifier
                                                        : Qt::NoModifier;
    if (m_navigator.flying() && Navigator::isFlyKey(event.key())) {
        if (!event.isAutoRepeat())
            m_navigator.flyKey(event.key(), pressed);
        return true;
    }
    m_pointer.modifiers = pressed ? event.modifiers() | changes : event.modifiers() & ~Qt::KeyboardModifiers(changes);
    if (event.key() == Qt::Key_F && !event.isAutoRepeat()) {
        if (m_drag)
            endDrag(true);
        if (pressed && m_gesture == Gesture::None && event.modifiers() == Qt::NoModifier)
            m_drag = ValueDrag{Dragged::Radius, draggedRadius()};
        else if (pressed && m_gesture == Gesture::None && event.modifiers() == Qt::ShiftModifier)
            m_drag = ValueDrag{Dragged::Strength, double(m_settings.choice(m_settings.toolRow()).strength)};
    }
    updateCursor();
    return false;
}

} // namespace ui
