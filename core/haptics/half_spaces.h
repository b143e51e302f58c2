// The place of a convex corner nearest to a goal: where a proxy goes that several contacts hold back
// (haptics/README 2.3). A quadratic program of three unknowns, solved by its conditions of Karush, Kuhn and Tucker.
#pragma once

#include "core/base/vec.h"

#include <optional>
#include <span>

namespace haptics {

/// The places q with normal.q >= offset; the normal is of unit length.
struct HalfSpace {
    base::Vec3d normal;
    double offset = 0;
};

/// The place of all half spaces nearest to `goal`; nothing where they have none in common, or only one that rounding
/// hides. REQUIRES: few of them, every set of up to three is looked at.
std::optional<base::Vec3d> nearestIn(std::span<const HalfSpace> spaces, const base::Vec3d& goal);

} // namespace haptics
