#include "ui/interaction/navigator.h"

#include <utility>

namespace ui {

Navigator::Navigator(QObject* parent) : QObject(parent), m_style(&navigationTable().front()) {
    m_timer.setInterval(12);
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Navigator::tick);
}

double Navigator::part() const {
    return m_transition ? static_cast<double>(m_transition->since.nsecsElapsed()) * 1e-9 / transitionSeconds : 1;
}

View Navigator::shown() const {
    const double t = part();
    return t >= 1 ? m_view : between(m_transition->from, m_view, t * t * (3 - 2 * t));
}

void Navigator::set(const View& view) {
    m_transition.reset();
    m_view = view;
    Q_EMIT moved(false);
}

void Navigator::goTo(const View& view) {
    if (!m_smooth || view == m_view)
        return set(view);
    m_transition = Transition{shown(), {}};
    m_transition->since.start();
    m_view = view;
    m_timer.start();
    Q_EMIT moved(true);
}

void Navigator::finish() {
    if (std::exchange(m_transition, std::nullopt))
        Q_EMIT moved(true);
}

void Navigator::chooseStyle(const NavigationRow& style) {
    m_style = &style;
    if (style.upright)
        goTo(m_view.upright());
}

void Navigator::drag(const ImagePoint& from, const ImagePoint& to, int width, int height) {
    m_transition.reset();
    m_style->drag(m_view, from, to, width, height);
}

void Navigator::pan(double dx, double dy, int height) {
    m_transition.reset();
    m_view.pan(dx, dy, height);
}

void Navigator::zoom(double steps, const base::Vec3d& about) {
    m_transition.reset();
    m_view.zoom(steps, about);
}

void Navigator::setParallel(bool parallel) {
    View view = m_view;
    view.parallel = parallel;
    set(view);
}

void Navigator::setPivot(const std::optional<base::Vec3d>& pivot) {
    m_view.pick(pivot);
}

// --- flying ---

void Navigator::takeOff(double speed) {
    m_transition.reset();
    m_fly.emplace(m_view, speed);
    m_view = m_fly->view();
    Q_EMIT flightChanged(true);
    Q_EMIT moved(false);
}

void Navigator::land() {
    m_fly.reset();
    m_timer.stop();
    Q_EMIT flightChanged(false);
    Q_EMIT moved(false);
}

static std::optional<Fly::Key> flyKeyOf(int key) {
    constexpr std::pair<int, Fly::Key> table[] = {
        {Qt::Key_W, Fly::Forward},   {Qt::Key_S, Fly::Back},    {Qt::Key_A, Fly::Left},
        {Qt::Key_D, Fly::Right},     {Qt::Key_E, Fly::Up},      {Qt::Key_Q, Fly::Down},
        {Qt::Key_Up, Fly::Forward},  {Qt::Key_Down, Fly::Back}, {Qt::Key_Left, Fly::Left},
        {Qt::Key_Right, Fly::Right}, {Qt::Key_PageUp, Fly::Up}, {Qt::Key_PageDown, Fly::Down},
        {Qt::Key_Shift, Fly::Fast}};
    for (const auto& [each, meaning] : table)
        if (each == key)
            return meaning;
    return {};
}

bool Navigator::isFlyKey(int key) {
    return flyKeyOf(key).has_value();
}

void Navigator::flyKey(int key, bool pressed) {
    const Fly::Key meaning = *flyKeyOf(key);
    if (pressed)
        m_fly->press(meaning);
    else
        m_fly->release(meaning);
    if (!m_timer.isActive()) {
        m_lastStep.start();
        m_timer.start();
    }
}

void Navigator::look(double dx, double dy, int height) {
    m_fly->look(dx, dy, height);
    m_view = m_fly->view();
    Q_EMIT moved(true);
}

double Navigator::accelerate(double steps) {
    m_fly->accelerate(steps);
    return m_fly->speed();
}

void Navigator::tick() {
    if (m_fly) {
        constexpr double longest = 0.25; // a stall is no leap
        m_fly->step(std::min(static_cast<double>(m_lastStep.nsecsElapsed()) * 1e-9, longest));
        m_lastStep.start();
        m_view = m_fly->view();
    } else if (m_transition && part() >= 1) {
        m_transition.reset();
    }
    const bool more = m_transition || (m_fly && m_fly->moving());
    if (!more)
        m_timer.stop();
    Q_EMIT moved(more);
}

} // namespace ui
