// The camera as a hand moves it: what it looks at, from how far, turned how. Plain value; no widget.
//
//     eye = target + R (0, 0, distance),   up = R (0, 1, 0),   right = R (1, 0, 0)
//
// In parallel projection the image is as high as perspective shows at the target, so that changing between the two
// leaves the target's surroundings as large as they were.
//
// It turns about its pivot: a place of the model that a person has picked, or the middle of what was framed, which goes
// along where the view is panned; without one, about the target. A pivot is not part of the picture: picking one moves
// no pixel. Pivot and target are two things: in perspective the middle of a model is not seen in the middle of its
// picture.
#pragma once

#include "core/base/mat3.h"
#include "core/render/camera.h"
#include "ui/view/rotation.h"

#include <optional>
#include <span>

namespace ui {

struct View {
    base::Vec3d target;
    double distance = 3; ///< from the eye to the target, > 0
    Rotation turn;       ///< camera axes (x right, y up, z towards the eye) to the model's
    double fovDeg = 35;
    bool parallel = false;
    base::UpAxis upAxis = base::UpAxis::Y; ///< of the model: what turntables turn about
    std::optional<base::Vec3d> pivot;      ///< what it turns about
    bool picked = false;                   ///< a person has chosen the pivot: it stays where it is

    bool operator==(const View&) const = default;

    render::Camera camera(int width, int height) const;
    /// The view whose camera looks as `camera` does.
    static View of(const render::Camera& camera);
    /// From the front, a little from the right and above.
    static View threeQuarter(std::span<const base::Box3f> boxes, int width, int height, base::UpAxis up);

    /// To turn about; nothing: the target.
    void pick(const std::optional<base::Vec3d>& place) {
        pivot = place;
        picked = place.has_value();
    }
    base::Vec3d turningPoint() const { return pivot.value_or(target); }
    /// Model units across the image's height, at the target.
    double heightAtTarget() const;
    /// The same target and distance, seen from a direction.
    void turnTo(const base::Vec3d& toEye, const base::Vec3d& up);
    /// Turns the camera about a place; the place keeps its place in the image.
    void turnAbout(const base::Vec3d& place, const Rotation& by);
    /// A direction of the camera (x right, y up, z towards the eye) as seen by the standing model.
    base::Vec3d standing(const base::Vec3d& axis) const { return toStanding(upAxis, turn(axis)); }
    /// Seen from coordinates that a rigid motion takes those of before to: the picture stays.
    void carry(const base::Mat3d& rotation, const base::Vec3d& shift);
    /// Another axis is upwards: the view turns with the model.
    void stand(base::UpAxis axis);
    /// The same direction with the model's own axis upwards, as far as it goes.
    View upright() const;
    /// The model follows the pointer in the plane through the target.
    void pan(double dx, double dy, int height);
    /// Nearer for positive steps, `pivot` keeps its place in the image.
    void zoom(double steps, const base::Vec3d& pivot);
    /// All of the boxes in the image, with as much room to the left as to the right and above as below, turning about
    /// their centre; the direction stays.
    void frame(std::span<const base::Box3f> boxes, int width, int height);
};

/// On the way from one view to another: `part` from 0 to 1. At 1 it is `to`, bit for bit.
View between(const View& from, const View& to, double part);

} // namespace ui
