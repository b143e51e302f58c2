#include "ui/view/view.h"

#include "core/render/close_up.h"

#include <algorithm>
#include <numbers>

namespace ui {

using base::Vec3d;
static constexpr double pi = std::numbers::pi;

double View::heightAtTarget() const {
    return 2 * distance * std::tan(fovDeg * pi / 360);
}

render::Camera View::camera(int width, int height) const {
    render::Camera out;
    out.target = target;
    out.eye = target + turn({0, 0, distance});
    out.up = turn({0, 1, 0});
    out.fovDeg = fovDeg;
    out.orthoHeight = parallel ? heightAtTarget() : 0;
    out.width = width;
    out.height = height;
    return out;
}

View View::of(const render::Camera& camera) {
    View out;
    out.target = camera.target;
    out.distance = length(camera.eye - camera.target);
    out.turn = Rotation::toAxes(camera.right(), camera.upright(), -camera.forward());
    out.fovDeg = camera.fovDeg;
    out.parallel = camera.parallel();
    if (out.parallel)
        out.distance *= camera.orthoHeight / out.heightAtTarget();
    return out;
}

void View::turnTo(const Vec3d& toEye, const Vec3d& up) {
    turn = Rotation::toAxes(cross(up, toEye), up, toEye);
}

void View::turnAbout(const Vec3d& place, const Rotation& by) {
    target = place + by(target - place);
    if (pivot && !picked)
        pivot = place + by(*pivot - place);
    turn = (by * turn).unit();
}

void View::carry(const base::Mat3d& rotation, const Vec3d& shift) {
    target = rotation * target + shift;
    if (pivot)
        pivot = rotation * *pivot + shift;
    const auto axis = [&](const Vec3d& of) { return rotation * of; };
    turn = (Rotation::toAxes(axis({1, 0, 0}), axis({0, 1, 0}), axis({0, 0, 1})) * turn).unit();
}

/// The standing frame to the model's coordinates.
static Rotation frameOf(base::UpAxis axis) {
    const base::UpRow& row = upRow(axis);
    return Rotation::toAxes(row.right, row.up, row.front);
}

void View::stand(base::UpAxis axis) {
    turn = (frameOf(axis) * frameOf(upAxis).inverse() * turn).unit();
    upAxis = axis;
}

View View::upright() const {
    const Vec3d back = standing({0, 0, 1});
    // Straight above or below, the heading is in the up vector alone.
    Vec3d heading{back.x, 0, back.z};
    if (length(heading) < 1e-9) {
        const Vec3d upwards = standing({0, 1, 0});
        heading = Vec3d{upwards.x, 0, upwards.z} * (back.y > 0 ? -1.0 : 1.0);
    }
    const Vec3d right = cross({0, 1, 0}, base::normalized(heading, {0, 0, 1}));
    View out = *this;
    out.turn = frameOf(upAxis) * Rotation::toAxes(right, cross(back, right), back);
    out.target = turningPoint() - out.turn(turn.inverse()(turningPoint() - target));
    return out;
}

void View::pan(double dx, double dy, int height) {
    const double unitsPerPixel = heightAtTarget() / std::max(height, 1);
    const Vec3d by = turn({-dx * unitsPerPixel, dy * unitsPerPixel, 0});
    target += by;
    if (pivot && !picked)
        *pivot += by;
}

void View::zoom(double steps, const Vec3d& about) {
    const double factor = std::pow(0.85, steps);
    target = about + (target - about) * factor;
    if (pivot && !picked)
        pivot = about + (*pivot - about) * factor;
    distance *= factor;
}

/// The corners of boxes, as a walk for close_up.h.
static auto cornersOf(std::span<const base::Box3f> boxes) {
    return [boxes](const auto& fn) {
        for (const base::Box3f& box : boxes)
            for (int corner = 0; corner < 8; ++corner)
                fn(base::cast<double>(base::Vec3f{corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y,
                                                  corner & 4 ? box.hi.z : box.lo.z}),
                   0.0);
    };
}

void View::frame(std::span<const base::Box3f> boxes, int width, int height) {
    constexpr double filled = 0.92; // of the image
    base::Box3f whole;
    for (const base::Box3f& box : boxes)
        whole.extend(box);
    if (whole.empty())
        return;
    const Vec3d centre = base::cast<double>(whole.centre());
    target = centre;
    pick({});
    pivot = centre;
    if (!(whole.diagonal() > 0)) // a single point: any distance shows it
        return;
    const render::Camera now = camera(width, height);
    if (!parallel) {
        const render::Camera near = render::closeUpOf(now, cornersOf(boxes), centre, filled);
        target = near.target;
        distance = length(near.eye - near.target);
        return;
    }
    const render::framing::Extents extents(now, cornersOf(boxes));
    target += extents.aside(now);
    if (const double tall = extents.height(now, filled); tall > 0) // else a point, as seen from here
        distance *= tall / heightAtTarget();
}

View View::threeQuarter(std::span<const base::Box3f> boxes, int width, int height, base::UpAxis up) {
    constexpr double yaw = 0.42, pitch = 0.366; // as render::Camera::looking, and for its reason
    View out;
    out.turn = frameOf(up) * Rotation::about({0, 1, 0}, yaw) * Rotation::about({1, 0, 0}, -pitch);
    out.upAxis = up;
    out.frame(boxes, width, height);
    return out;
}

View between(const View& from, const View& to, double part) {
    if (part >= 1)
        return to;
    View out = to;
    out.turn = Rotation::between(from.turn, to.turn, part);
    out.target = from.target + (to.target - from.target) * part;
    out.distance = from.distance * std::pow(to.distance / from.distance, part);
    out.fovDeg = from.fovDeg + (to.fovDeg - from.fovDeg) * part;
    return out;
}

} // namespace ui
