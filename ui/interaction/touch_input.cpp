#include "ui/interaction/touch_input.h"

#include "core/session/touch_strokes.h"
#include "ui/interaction/contact.h"

#include <numbers>
#include <QApplication>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <QWidget>

namespace ui {

using base::Vec3d;
using haptics::DeviceKind;

namespace {

constexpr int pollMs = 8;
/// Metres: how far in front of the model a hand begins, how deep the simulated one and a button press it.
constexpr double before = 0.03, deep = 0.012;
constexpr double wheelStep = 0.002;
/// Newtons a second: half a metre a second against the stiffest clay there is.
constexpr double mostSlew = 1500;

/// In a device's frame: to the surface in front, eights on it for a while, and back.
haptics::Trajectory demonstration() {
    constexpr double seconds = 16, eight = 4;
    haptics::Trajectory out;
    for (int i = 0; i <= 800; ++i) {
        const double t = seconds * i / 800, u = 2 * std::numbers::pi * t / eight;
        const double in = std::min({1.0, t / 1.0, (seconds - t) / 1.0});
        out.push_back({t, {0.03 * std::sin(u) * in, 0.02 * std::sin(2 * u) * in, -(before + deep) * in}});
    }
    return out;
}

} // namespace

TouchInput::TouchInput(const Parts& parts, QWidget& canvas, QObject* parent)
    : QObject(parent), m_parts(parts), m_canvas(canvas) {
    m_clock.setInterval(pollMs);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, &TouchInput::poll);
    connect(&parts.editor, &Editor::changed, this, [this] {
        if (m_live)
            m_live->show(m_parts.editor.snapshot().surface);
    });
    connect(&parts.motion, &ViewMotion::moved, this, &TouchInput::tellView);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (m_live)
            m_live->focus(state == Qt::ApplicationActive);
    });
}

TouchInput::~TouchInput() {
    disconnect();
    m_live.reset();
}

void TouchInput::set(const TouchSettings& settings) {
    const TouchSettings was = m_set;
    m_set = settings;
    if (!settings.on || settings.device != was.device || settings.viewDevice != was.viewDevice)
        close();
    if (settings.on && !m_live)
        open();
    else if (settings.reach != was.reach)
        tellView();
}

bool TouchInput::stop() {
    if (!m_live)
        return false;
    m_live->focus(false);
    close();
    m_set.on = false;
    Q_EMIT stopped();
    return true;
}

double TouchInput::scale() const {
    return m_pointer ? m_options.workspace.scale : m_parts.motion.view().heightAtTarget() / (0.01 * m_set.reach);
}

/// The view's axes, and a place in front of what is in the middle of the picture.
haptics::ViewFrame TouchInput::frame() const {
    const render::Camera camera = m_parts.motion.camera();
    const Vec3d x = camera.right(), y = camera.upright(), z = -camera.forward();
    haptics::ViewFrame out;
    out.turn = {{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}};
    out.scale = scale();
    const auto contact =
        contactAt(m_parts.editor.snapshot().surface, camera, QPointF(0.5 * camera.width, 0.5 * camera.height));
    out.middle = (contact ? contact->position : m_parts.motion.view().target) + z * (before * out.scale);
    return out;
}

haptics::ServoOptions TouchInput::servoOptions() const {
    const sculpt::ToolRow& row = m_parts.settings.toolRow();
    const double radius = m_parts.sizing.radiusAt(m_parts.motion.view().target); // the same while it moves
    haptics::ServoOptions out = m_options;
    out.tool = {m_set.tip * radius, m_set.friction};
    out.law.stiffness = m_set.stiffness;
    out.law.texture = {m_set.relief, m_set.grain};
    haptics::TouchLaw law;
    law.viscosity = m_set.viscosity;
    out.touch = session::touchLawOf(strokeSettings(m_parts.settings, row, static_cast<float>(radius), false), law);
    out.touch.works = m_set.sculpts && (!row.needs.source || m_parts.source.place());
    return out;
}

std::unique_ptr<haptics::Device> TouchInput::openDevice() {
    const haptics::DeviceRow& row = haptics::device(m_set.device);
    m_pointer = row.kind == DeviceKind::Pointer ? std::make_shared<haptics::Mailbox<haptics::DeviceState>>() : nullptr;
    return row.open({demonstration(), {}, m_pointer});
}

void TouchInput::open() {
    try {
        auto device = openDevice();
        m_options = {};
        m_options.safety.mostForce = 8;
        m_options.safety.mostSlew = mostSlew;
        m_options.safety.mostJump = 0.01 * m_options.safety.mostForce;
        m_options.workspace.scale = m_parts.motion.view().heightAtTarget() / (0.01 * m_set.reach);
        m_options.workspace.centre = m_pointer ? Vec3d{} : frame().middle;
        m_options = servoOptions();
        if (m_set.viewDevice && m_set.device != "space-mouse")
            m_viewDevice = haptics::device("space-mouse").open({});
        m_live = std::make_unique<haptics::Live>(std::move(device), m_options);
    } catch (const base::Error& error) {
        m_set.on = false;
        Q_EMIT hinted(QString::fromStdString(error.message()));
        Q_EMIT stopped();
        return;
    }
    m_live->show(m_parts.editor.snapshot().surface);
    m_live->focus(qApp->applicationState() == Qt::ApplicationActive || qApp->platformName() == "offscreen");
    if (m_pointer) {
        m_canvas.installEventFilter(this);
        m_depth = m_pressed = 0;
        m_plane = frame().middle;
    }
    tellView();
    m_clock.start();
}

void TouchInput::close() {
    m_clock.stop();
    endStroke();
    m_canvas.removeEventFilter(this);
    m_live.reset(); // sends a zero force
    m_viewDevice.reset();
    m_pointer.reset();
    m_stroke = 0;
    if (m_look.shown) {
        m_look = {};
        Q_EMIT felt();
    }
}

void TouchInput::tellView() {
    if (m_pointer)
        m_plane = frame().middle;
    else if (m_live)
        m_live->look(frame());
}

void TouchInput::poll() {
    if (m_live->ended()) { // the simulated hand begins anew
        const TouchSettings again = m_set;
        close();
        m_set = again;
        open();
        return;
    }
    if (const haptics::ServoOptions wanted = servoOptions();
        wanted.tool != m_options.tool || wanted.law != m_options.law || wanted.touch != m_options.touch) {
        m_options = wanted;
        m_live->tune(wanted);
    }
    turnView();
    const haptics::Tick* tick = m_live->newest();
    if (!tick)
        return;
    m_look.shown = m_live->connected();
    m_look.contact = tick->contact;
    m_look.works = tick->touched.working();
    m_look.tool = tick->tool;
    m_look.proxy = m_look.works && tick->touched.phase == haptics::Touching::Holds ? tick->tool : tick->proxy;
    m_look.radius = m_options.tool.radius;
    m_look.force = tick->force / scale();
    sculpt(tick->touched);
    Q_EMIT felt();
}

void TouchInput::sculpt(const haptics::Touched& touched) {
    if (m_stroking && (!touched.working() || touched.stroke != m_stroke))
        endStroke();
    if (!touched.working())
        return;
    if (!m_stroking) {
        if (touched.stroke == m_stroke) // it was taken back
            return;
        m_stroke = touched.stroke;
        if (!m_parts.editor.ready() || m_parts.pointer.gesture() == PointerRouter::Gesture::Sculpt)
            return;
        const sculpt::ToolRow& row = m_parts.settings.toolRow();
        const auto radius = static_cast<float>(m_parts.sizing.radiusAt(touched.place));
        sculpt::StrokeSettings stroke = strokeSettings(m_parts.settings, row, radius, false);
        stroke.stampUpright = m_parts.editor.snapshot().up;
        if (row.needs.source)
            m_parts.source.addTo(stroke, touched.place);
        m_parts.editor.beginStroke(stroke);
        m_stroking = true;
    }
    m_parts.editor.addSample(session::sampleOf(touched));
}

void TouchInput::endStroke() {
    if (m_stroking)
        m_parts.editor.endStroke();
    m_stroking = false;
}

/// What the 3D mouse does to the view while another device is the tool.
void TouchInput::turnView() {
    haptics::DeviceState state;
    if (!m_viewDevice || !m_viewDevice->read(state))
        return;
    constexpr double pixelsPerRadian = 200, pixelsPerMetre = 3000;
    const double seconds = 0.001 * pollMs;
    const QPointF turn(state.turning.y * seconds * pixelsPerRadian, state.turning.x * seconds * pixelsPerRadian);
    const QPointF middle(0.5 * m_canvas.width(), 0.5 * m_canvas.height());
    if (!turn.isNull())
        m_parts.motion.orbit(middle, middle + turn);
    const QPointF pan(state.velocity.x * seconds * pixelsPerMetre, -state.velocity.y * seconds * pixelsPerMetre);
    if (!pan.isNull())
        m_parts.motion.pan(pan);
}

/// Where the pointer is in space: on its ray, behind the plane in front of the model.
void TouchInput::point() {
    const render::Camera camera = m_parts.motion.camera();
    const base::Rayd ray = camera.ray(m_pixel.x(), m_pixel.y());
    const double scale = m_options.workspace.scale, depth = (m_depth + m_pressed) * scale;
    const double along = (dot(m_plane - ray.origin, camera.forward()) + depth) / dot(ray.direction, camera.forward());
    haptics::DeviceState state;
    state.position = ray.at(along) / scale;
    state.time = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    m_pointer->put(state);
}

bool TouchInput::eventFilter(QObject*, QEvent* event) {
    if (!m_pointer)
        return false;
    const double pixelRatio = m_canvas.devicePixelRatioF();
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove: {
        const auto& mouse = static_cast<QMouseEvent&>(*event);
        m_pixel = mouse.position() * pixelRatio;
        if (mouse.buttons() & (Qt::MiddleButton | Qt::RightButton)) // the view's
            return false;
        m_pressed = mouse.buttons() & Qt::LeftButton ? before + deep : 0;
        point();
        return mouse.button() == Qt::LeftButton || mouse.buttons() & Qt::LeftButton;
    }
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease: {
        auto& pen = static_cast<QTabletEvent&>(*event);
        m_pixel = pen.position() * pixelRatio;
        m_pressed = (before + deep) * pen.pressure();
        point();
        pen.accept();
        return true;
    }
    case QEvent::Wheel:
        m_depth += wheelStep * static_cast<QWheelEvent&>(*event).angleDelta().y() / 120.0;
        point();
        return true;
    default:
        return false;
    }
}

QString TouchInput::state() const {
    if (!m_live)
        return {};
    if (!m_live->connected())
        return tr("waiting for the device");
    const QString late = tr("%1 late ticks").arg(m_live->missed());
    return m_live->realtime() ? late : tr("%1, no priority").arg(late);
}

} // namespace ui
