// A rigid motion: x -> R x + t, in float64. A value.
#pragma once

#include "core/base/mat3.h"

namespace process {

struct Rigid {
    base::Mat3d rotation = base::Mat3d::identity();
    base::Vec3d translation;

    bool operator==(const Rigid&) const = default;
    base::Vec3d operator()(const base::Vec3d& x) const { return rotation * x + translation; }
    base::Vec3d turn(const base::Vec3d& direction) const { return rotation * direction; }
    /// First `o`, then this.
    Rigid operator*(const Rigid& o) const { return {rotation * o.rotation, (*this)(o.translation)}; }
    Rigid inverse() const {
        const base::Mat3d back = transposed(rotation);
        return {back, -(back * translation)};
    }
};

/// A turn by |w| about w, then a shift.
Rigid motionOf(const base::Vec3d& w, const base::Vec3d& shift);

/// The motion that brings `from` nearest to `to`, place by place [Arun87]; nothing for fewer than 3, or where they lie
/// on a line.
bool bestMotion(const base::Vec3d* from, const base::Vec3d* to, std::size_t count, Rigid& out);

} // namespace process
