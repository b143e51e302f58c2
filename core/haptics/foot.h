// Feet: the places of the surface that a tool touches or is close to, each with the side that the tool is on. They are
// followed from tick to tick along the exact surface, in float64, so that nothing is ever decided anew
// (haptics/README 2.1, 2.2).
//
// Everything is a free function of a surface and may run on any thread; `track` and `firstMet` allocate nothing.
#pragma once

#include "core/surface/surface.h"

#include <array>
#include <optional>
#include <span>

namespace haptics {

struct Foot {
    base::Vec3d position;  ///< on the surface
    base::Vec3d normal;    ///< unit gradient, turned to the side that the tool is on
    double side = 1;       ///< 1 where that is the gradient's own direction, -1 where it is the other
    double unit = 0;       ///< h there
    double agreement = 1;  ///< 1 on one flat sheet
    base::Mat3d bend = {}; ///< how the normal turns along the surface

    /// How far x is from the surface, negative behind it.
    double height(const base::Vec3d& x) const { return dot(x - position, normal); }
    /// Takes the other side.
    void turn();
    /// The tangent plane's shape at distance `radius` in front of the surface.
    base::Mat3d bendAt(double radius) const;
};

enum class Tracked {
    Found,  ///< `out` is the foot of x on the sheet that it came from
    Turned, ///< a foot whose normal differs by more than 60 degrees
    Ended,  ///< the surface has ended on the way there: a rim
    Lost,   ///< the surface says nothing clear on the way there
};

/// The foot of x on the sheet of `from`, near it: Newton's steps along the surface, with the side carried along.
Tracked track(const surface::Surface& surface, const base::Vec3d& x, const Foot& from, Foot& out);

/// The foot where the way from one place to another first meets the surface. It begins a hair in front of the sheets
/// of `own`; a short one does not meet what goes on as they do, which following them tells better.
std::optional<Foot> firstMet(const surface::Surface& surface, const base::Vec3d& from, const base::Vec3d& to,
                             std::span<const Foot> own);

/// The foot nearest to x on any sheet, on the side that x is on, or one nearly so where several are; nothing where none
/// is found.
std::optional<Foot> nearestFoot(const surface::Surface& surface, const base::Vec3d& x);

/// The same place of another version of the surface, however far the surface moved there along its normal. Nothing
/// where it is gone.
std::optional<Foot> carried(const surface::Surface& now, const Foot& before);

} // namespace haptics
