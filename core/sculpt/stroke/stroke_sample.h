// Where the pointer was, as a ray.
#pragma once

#include "core/base/ray.h"

namespace sculpt {

struct StrokeSample {
    base::Rayf ray;     ///< through the pointer, in model coordinates relative to the origin; any direction length > 0
    float pressure = 1; ///< 0 to 1
    float seconds = 0;  ///< since the stroke began
    /// On the way here dabs are this many times as far apart and as strong: what a program that cannot keep up merges.
    float stride = 1; ///< 1 to maxStride
    static constexpr float maxStride = 10;
    /// Where along the ray the pointer is, in model units, where it has a place in space: a device that is held in the
    /// hand. Tools that drag take what they hold there. 0: the pointer is a ray alone.
    float reach = 0;

    bool operator==(const StrokeSample& o) const {
        return ray.origin == o.ray.origin && ray.direction == o.ray.direction && pressure == o.pressure &&
               seconds == o.seconds && stride == o.stride && reach == o.reach;
    }
};

/// Part `u` of the way from `a` to `b`; the direction is normalised, the stride is that of `b`.
inline StrokeSample between(const StrokeSample& a, const StrokeSample& b, float u) {
    StrokeSample out;
    out.ray.origin = a.ray.origin + (b.ray.origin - a.ray.origin) * u;
    out.ray.direction = normalized(a.ray.direction + (b.ray.direction - a.ray.direction) * u, b.ray.direction);
    out.pressure = a.pressure + (b.pressure - a.pressure) * u;
    out.seconds = a.seconds + (b.seconds - a.seconds) * u;
    out.stride = b.stride;
    out.reach = a.reach > 0 && b.reach > 0 ? a.reach + (b.reach - a.reach) * u : b.reach;
    return out;
}

} // namespace sculpt
