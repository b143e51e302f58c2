#include "ui/view/navigation.h"

#include "core/base/row_of_id.h"

#include <algorithm>
#include <numbers>

namespace ui {

using base::Vec3d;
static constexpr double pi = std::numbers::pi;

/// Half a turn for the image's height.
static double perPixel(int height) {
    return pi / std::max(height, 1);
}

static void turntable(View& view, const ImagePoint& from, const ImagePoint& to, int, int height) {
    const Vec3d pivot = view.turningPoint(), back = view.standing({0, 0, 1}), up = view.standing({0, 1, 0});
    view.turnAbout(pivot, Rotation::about(upRow(view.upAxis).up, -(to.x - from.x) * perPixel(height)));
    // The eye's height above the horizon; on the way over a pole it stops there.
    const double pitch = std::atan2(back.y, std::copysign(std::hypot(back.x, back.z), up.y));
    const double wanted =
        std::clamp(pitch + (to.y - from.y) * perPixel(height), std::min(pitch, -pi / 2), std::max(pitch, pi / 2));
    view.turnAbout(pivot, Rotation::about(view.turn({1, 0, 0}), pitch - wanted));
}

static void orbit(View& view, const ImagePoint& from, const ImagePoint& to, int, int height) {
    const double dx = (to.x - from.x) * perPixel(height), dy = (to.y - from.y) * perPixel(height);
    const double angle = std::hypot(dx, dy);
    if (angle > 0)
        view.turnAbout(view.turningPoint(), Rotation::about(view.turn(Vec3d{-dy, -dx, 0} / angle), angle));
}

/// On a ball of half the image's smaller side; beyond 1/sqrt(2) of its radius, on the hyperbola that continues it
/// smoothly: Bell's virtual trackball [Henriksen04].
static Vec3d onBall(const ImagePoint& at, int width, int height) {
    const double radius = 0.5 * std::min(width, height);
    const double x = (at.x - 0.5 * width) / radius, y = (0.5 * height - at.y) / radius, square = x * x + y * y;
    return base::normalized(Vec3d{x, y, square < 0.5 ? std::sqrt(1 - square) : 0.5 / std::sqrt(square)});
}

static void trackball(View& view, const ImagePoint& from, const ImagePoint& to, int width, int height) {
    const Vec3d a = onBall(from, width, height), b = onBall(to, width, height), axis = cross(a, b);
    const double sine = length(axis);
    if (!(sine > 0))
        return;
    const double angle = std::atan2(sine, dot(a, b));
    // The model follows the pointer: the camera turns the other way.
    view.turnAbout(view.turningPoint(), Rotation::about(view.turn(axis / sine), -angle));
}

static void lookAround(View& view, const ImagePoint& from, const ImagePoint& to, int, int height) {
    const double angle = view.fovDeg * pi / 180 / std::max(height, 1); // what is under the pointer follows it
    const Vec3d eye = view.target + view.turn({0, 0, view.distance});
    view.turnAbout(eye, Rotation::about(upRow(view.upAxis).up, (to.x - from.x) * angle));
    const Vec3d back = view.standing({0, 0, 1}), up = view.standing({0, 1, 0});
    const double pitch = std::atan2(-back.y, std::copysign(std::hypot(back.x, back.z), up.y));
    const double wanted =
        std::clamp(pitch + (to.y - from.y) * angle, std::min(pitch, -pi / 2), std::max(pitch, pi / 2));
    view.turnAbout(eye, Rotation::about(view.turn({1, 0, 0}), wanted - pitch));
}

std::span<const NavigationRow> navigationTable() {
    static const NavigationRow table[] = {
        {"turntable", "Turntable", "Drag to turn the view about the model's upright axis; up stays up", true,
         turntable},
        {"orbit", "Orbit", "Drag to turn the view about the picture's own axes, across the poles", false, orbit},
        {"trackball", "Trackball",
         "A ball in the middle of the picture follows the pointer; outside the ball, the view rolls", false, trackball},
        {"fly", "Look Around", "Drag to look around from where you are; F4 flies", true, lookAround},
    };
    return table;
}

const NavigationRow& navigation(std::string_view id) {
    const NavigationRow* found = base::findRow(navigationTable(), id);
    return found ? *found : navigationTable().front();
}

} // namespace ui
