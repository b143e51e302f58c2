// Where handles put something: moved, turned and scaled about its middle. Plain values, no Qt.
//
// Handles stand at the middle, as large in the picture whatever the distance: an arrow along each axis moves, a ring
// about each axis turns, the dot in the middle moves across the view, the square beside it scales. What is grasped
// stays under the pointer: moves follow the rays of its pixels, turns the places where these meet the ring's plane.
#pragma once

#include "core/render/camera.h"
#include "ui/view/rotation.h"

#include <optional>
#include <vector>

namespace ui {

struct Placement {
    base::Vec3d move;
    Rotation turn;
    double scale = 1;
    bool operator==(const Placement&) const = default;
};

struct AxisAngle {
    base::Vec3d axis{0, 0, 1};
    double degrees = 0; ///< 0 to 180
};
AxisAngle axisAngleOf(const Rotation& turn);
Rotation rotationOf(const AxisAngle& turn);

struct Handle {
    enum class Kind { Move, Turn, Free, Scale };
    Kind kind = Kind::Move;
    int axis = 0; ///< of moves and turns
    bool operator==(const Handle&) const = default;
};

struct HandleShape {
    Handle handle;
    std::vector<base::Vec3d> line; ///< model coordinates; one place: a dot
};
/// `lengthPx`: of arrows, in pixels of the camera.
std::vector<HandleShape> handleShapes(const render::Camera& camera, const base::Vec3d& middle, double lengthPx);
/// The nearest within `reachPx` of a place in the picture.
std::optional<Handle> handleAt(const render::Camera& camera, const base::Vec3d& middle, double lengthPx, double px,
                               double py, double reachPx);

struct HandleDrag {
    Handle handle;
    Placement before;
    base::Vec3d middle; ///< where it was when the drag began
    double fromX = 0, fromY = 0;
};
/// With the pointer at a place of the picture. `steps`: turns by whole 15 degrees, scales by whole tenths.
Placement dragged(const HandleDrag& drag, const render::Camera& camera, double px, double py, bool steps);

} // namespace ui
