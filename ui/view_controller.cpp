#include "ui/view_controller.h"

#include "core/surface/intersect.h"
#include "ui/annotation_overlay.h"
#include "ui/symmetry_overlay.h"

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
}

render::Camera ViewController::camera() const {
    const QWidget* widget = m_viewport.widget();
    const double scale = widget->devicePixelRatioF();
    return m_view.camera(std::max(1, qRound(widget->width() * scale)), std::max(1, qRound(widget->height() * scale)));
}

void ViewController::refresh(bool moving) {
    Frame frame{m_editor.snapshot().surface.tree(), camera(), {}, moving};
    frame.options = look();
    frame.options.colours = m_colours;
    frame.input = std::max(m_editor.snapshot().input, m_viewInput);
    frame.options.definition = m_editor.snapshot().surface.definition();
    frame.options.splatScale = m_editor.snapshot().splatScale;
    m_viewport.show(frame);
    updateCursor();
}

render::RenderOptions ViewController::look() const {
    render::RenderOptions out = lookOf(m_settings);
    out.pixelScale = static_cast<float>(m_viewport.widget()->devicePixelRatioF());
    if (m_settings.grid)
        out.grid = m_grid;
    return out;
}

void ViewController::showColours(std::shared_ptr<const render::BlockColours> colours,
                                 const std::optional<render::ColourScale>& scale) {
    m_scale = scale;
    if (colours == m_colours)
        return;
    m_colours = std::move(colours);
    refresh(m_gesture != Gesture::None);
}

/// The model's shape as far as framing needs it: a box for each block.
static std::vector<base::Box3f> boxesOf(const tree::SurfelTree& tree) {
    std::vector<base::Box3f> out;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) { out.push_back(block.box()); });
    return out;
}

void ViewController::followModel() {
    const Snapshot& snapshot = m_editor.snapshot();
    if (snapshot.models != m_models) {
        m_models = snapshot.models;
        chooseSource({});
        m_grid = render::gridBelow(snapshot.surface.tree().bounds(), camera().up, snapshot.origin);
        const render::Camera now = camera();
        m_view = OrbitView::threeQuarter(boxesOf(snapshot.surface.tree()), now.width, now.height);
    }
    refresh(m_gesture != Gesture::None);
}

void ViewController::frameAll() {
    const render::Camera now = camera();
    m_view.frame(boxesOf(m_editor.snapshot().surface.tree()), now.width, now.height);
    refresh();
}

void ViewController::turnTo(const render::NamedView& view) {
    m_view.turnTo(view.toEye, view.up);
    refresh();
}

// --- the brush ---

std::optional<BrushContact> ViewController::contactAt(const QPointF& place) const {
    const base::Rayd ray = camera().ray(place.x(), place.y());
    const base::Rayf narrow{base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))};
    const surface::Surface& surface = m_editor.snapshot().surface;
    if (surface.tree().empty())
        return {};
    const surface::RayHit<float> hit = surface::intersect(surface, narrow);
    if (!hit.hit)
        return {};
    return BrushContact{base::cast<double>(hit.position), base::cast<double>(hit.normal)};
}

double ViewController::pixelsAt(const Vec3d& p) const {
    const render::Camera now = camera();
    return now.pixelsPerUnit(std::max(now.project(p).z, 1e-12 * m_view.distance));
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
    if (m_inside && (m_gesture == Gesture::None || m_gesture == Gesture::Sculpt)) {
        m_cursor.contact = contactAt(m_pointer.place);
        if (m_cursor.contact)
            m_cursor.radius = worldRadius(m_cursor.contact->position);
        else if (m_settings.radiusUnit == RadiusUnit::Pixels)
            m_cursor.radiusPx = m_settings.radiusPx * m_viewport.widget()->devicePixelRatioF();
        else
            m_cursor.radiusPx = m_settings.radiusModel * pixelsAt(m_view.target);
    }
    m_viewport.widget()->update();
}

void ViewController::paintOverlay(QPainter& painter) const {
    const double scale = 1 / m_viewport.widget()->devicePixelRatioF();
    painter.save();
    painter.scale(scale, scale);
    const Snapshot& now = m_editor.snapshot();
    const render::Camera seen = camera();
    if (m_settings.symmetry != sculpt::Symmetry{} && !now.surface.tree().empty())
        paint(painter, SymmetryOverlay{m_settings.symmetry, now.origin, now.surface.tree().bounds(), m_cursor.contact},
              seen);
    if (m_source && sculpt::hasSource(m_settings.toolRow())) {
        const bool going = m_gesture == Gesture::Sculpt && m_cursor.contact;
        paintSource(painter, *m_source + (going ? m_cursor.contact->position - m_strokeStart : Vec3d{}), seen);
    }
    paint(painter, render::annotate(m_settings.annotated, seen, m_scale, m_settings.backdrop, look().pixelScale));
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
    const base::Rayd ray = camera().ray(pointer.place.x(), pointer.place.y());
    sculpt::StrokeSample sample;
    sample.ray = {base::cast<float>(ray.origin), base::normalized(base::cast<float>(ray.direction))};
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
    return false;
}

// --- gestures ---

void ViewController::press(const Pointer& pointer) {
    ++m_inputs;
    if (m_gesture != Gesture::None)
        return;
    m_pointer = pointer;
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
    const QPointF by = pointer.place - m_pointer.place;
    const int height = camera().height;
    m_pointer = pointer;
    m_inside = true;
    if (m_drag && m_gesture == Gesture::None)
        return dragValue(by.x());
    if (m_gesture == Gesture::Sculpt)
        addSample(pointer);
    else if (m_gesture == Gesture::Orbit)
        m_view.orbit(by.x(), by.y(), height);
    else if (m_gesture == Gesture::Pan)
        m_view.pan(by.x(), by.y(), height);
    if (m_gesture == Gesture::Orbit || m_gesture == Gesture::Pan) {
        m_viewInput = m_inputs;
        refresh(true);
    } else
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
    case QEvent::Enter:
        m_viewport.widget()->setFocus(Qt::MouseFocusReason);
        return false;
    case QEvent::Leave:
    case QEvent::FocusOut:
        m_inside = false;
        if (m_drag)
            endDrag(true);
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

bool ViewController::mouse(QMouseEvent& event) {
    const double scale = m_viewport.widget()->devicePixelRatioF();
    const Pointer pointer{event.position() * scale, event.button(), event.modifiers(), 1};
    if (event.type() == QEvent::MouseMove)
        move(pointer);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(pointer);
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
    const auto under = contactAt(event.position() * scale);
    if (m_gesture != Gesture::Sculpt) {
        m_view.zoom(event.angleDelta().y() / 120.0, under ? under->position : m_view.target);
        refresh(true);
    }
    event.accept();
    return true;
}

bool ViewController::key(QKeyEvent& event, bool pressed) {
    const auto changes = event.key() == Qt::Key_Control ? Qt::ControlModifier
                         : event.key() == Qt::Key_Shift ? Qt::ShiftModifier
                                                        : Qt::NoModifier;
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
