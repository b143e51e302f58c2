#include "ui/interaction/view_motion.h"

#include "ui/interaction/framing.h"

#include <algorithm>
#include <QWidget>

namespace ui {

using base::Vec3d;

ViewMotion::ViewMotion(const Editor& editor, const CutPlanes& cuts, const QWidget& canvas, QObject* parent)
    : QObject(parent), m_editor(editor), m_cuts(cuts), m_canvas(canvas) {
    connect(&m_navigator, &Navigator::moved, this, &ViewMotion::moved);
    connect(&m_navigator, &Navigator::flightChanged, this, &ViewMotion::changed);
}

render::Camera ViewMotion::cameraOf(const View& view) const {
    const double scale = m_canvas.devicePixelRatioF();
    const int width = std::max(1, qRound(m_canvas.width() * scale));
    const int height = std::max(1, qRound(m_canvas.height() * scale));
    render::Camera out = view.camera(width, height);
    out.clips = m_cuts.cuts().planes();
    return out.before(m_editor.snapshot().whole.bounds());
}

double ViewMotion::pixelsPerUnitAt(const Vec3d& place) const {
    const render::Camera now = camera();
    return now.pixelsPerUnit(std::max(now.project(place).z, 1e-12 * view().distance));
}

// --- drags ---

void ViewMotion::orbit(const QPointF& fromPx, const QPointF& toPx) {
    const render::Camera now = camera();
    m_navigator.drag({fromPx.x(), fromPx.y()}, {toPx.x(), toPx.y()}, now.width, now.height);
    Q_EMIT moved(true);
}

void ViewMotion::pan(const QPointF& byPx) {
    m_navigator.pan(byPx.x(), byPx.y(), camera().height);
    Q_EMIT moved(true);
}

// --- views ---

void ViewMotion::showNewModel() {
    const render::Camera now = camera();
    View fresh = View::threeQuarter(boxesOf(m_editor.snapshot().whole), now.width, now.height, m_editor.snapshot().up);
    fresh.parallel = view().parallel;
    m_navigator.set(fresh);
}

void ViewMotion::frameAll() {
    frame(boxesOf(m_editor.snapshot().whole));
}

void ViewMotion::frame(std::span<const base::Box3f> boxes) {
    const render::Camera now = camera();
    View there = view();
    there.frame(boxes, now.width, now.height);
    m_navigator.goTo(there);
}

void ViewMotion::turnTo(const render::NamedView& named) {
    View there = view();
    const render::NamedView seen = named.of(there.upAxis);
    there.turnTo(seen.toEye, seen.up);
    there.target = there.turningPoint() - there.turn(view().turn.inverse()(there.turningPoint() - view().target));
    m_navigator.goTo(there);
}

void ViewMotion::lookFrom(const Vec3d& toEye) {
    for (const render::NamedView& each : render::namedViews())
        if (each.of(view().upAxis).toEye == toEye)
            turnTo(each);
}

void ViewMotion::stand(base::UpAxis up) {
    if (m_navigator.flying())
        m_navigator.land();
    const render::Camera now = camera();
    View there = view();
    there.stand(up);
    there.frame(boxesOf(m_editor.snapshot().whole), now.width, now.height);
    m_navigator.goTo(there);
}

void ViewMotion::follow(const process::Rigid& motion) {
    if (m_navigator.flying())
        m_navigator.land();
    View there = view();
    there.carry(motion.rotation, motion.translation);
    there.upAxis = m_editor.snapshot().up;
    m_navigator.set(there);
}

void ViewMotion::toggleParallel() {
    m_navigator.setParallel(!view().parallel);
    Q_EMIT changed();
}

SavedView ViewMotion::savedView(const std::string& name) const {
    return {name, view(), m_editor.snapshot().origin};
}

void ViewMotion::recall(const SavedView& saved) {
    View there = saved.forOrigin(m_editor.snapshot().origin);
    there.upAxis = m_editor.snapshot().up;
    m_navigator.goTo(there);
    Q_EMIT changed();
}

} // namespace ui
