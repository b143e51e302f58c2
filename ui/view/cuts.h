// What the window cuts away: a plane across each axis and a free one, each on or off. Plain value; stored coordinates.
#pragma once

#include "core/base/box.h"
#include "core/base/plane.h"
#include "core/render/clip_planes.h"

#include <array>

namespace ui {

struct Cut {
    bool on = false, flipped = false;
    base::Vec3d normal; ///< unit
    double offset = 0;  ///< normal . x on the plane; what lies at or below it is shown, or above it if flipped

    bool operator==(const Cut&) const = default;

    base::Plane plane() const { return flipped ? base::Plane{normal, offset} : base::Plane{-normal, -offset}; }
};

struct Cuts {
    /// Across x, y and z, then the free one, whose normal comes from the view.
    std::array<Cut, 4> each{
        Cut{.normal = {1, 0, 0}}, {.normal = {0, 1, 0}}, {.normal = {0, 0, 1}}, {.normal = {0, 0, 1}}};
    bool section = true; ///< draw the curves in which the planes meet the surface

    bool operator==(const Cuts&) const = default;

    render::ClipPlanes planes() const {
        render::ClipPlanes out;
        for (const Cut& cut : each)
            if (cut.on)
                out.add(cut.plane());
        return out;
    }
    static constexpr std::size_t free = 3;
};

/// Least and largest offset at which a plane of that normal meets the box.
struct OffsetRange {
    double low = 0, high = 0;

    double middle() const { return 0.5 * (low + high); }
};
inline OffsetRange offsetRange(const base::Box3f& box, const base::Vec3d& normal) {
    if (box.empty())
        return {};
    const base::Vec3d half = base::cast<double>(box.hi - box.lo) * 0.5;
    const double middle = dot(base::cast<double>(box.centre()), normal);
    const double extent = std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
    return {middle - extent, middle + extent};
}

} // namespace ui
