// What light does at a smooth surface (raycast/README 4.6). All directions are unit vectors; n faces against d.
#pragma once

#include "core/base/vec.h"

#include <algorithm>
#include <optional>

namespace raycast {

/// Rays that carry less of the picture's light are not followed; their light goes with the other ray of the pair. Just
/// below what glass reflects head-on, so that its first reflection is followed, and those inside only where strong.
constexpr float leastPart = 0.039f;

inline base::Vec3f mirrored(const base::Vec3f& d, const base::Vec3f& n) {
    return normalized(d - n * (2 * dot(d, n)));
}

/// Snell's law: sin(out) = eta sin(in), eta = index before / index behind. None where all light is reflected.
inline std::optional<base::Vec3f> refracted(const base::Vec3f& d, const base::Vec3f& n, float eta) {
    const float c = -dot(d, n), k = 1 - eta * eta * (1 - c * c);
    if (k < 0)
        return std::nullopt;
    return normalized(d * eta + n * (eta * c - std::sqrt(k)));
}

/// Fresnel's equations for unpolarised light: the part reflected of a ray that arrives with cosine c.
inline float reflectance(float c, float eta) {
    const float k = 1 - eta * eta * (1 - c * c);
    if (k <= 0)
        return 1;
    const float behind = std::sqrt(k);
    const float across = (eta * c - behind) / (eta * c + behind), along = (c - eta * behind) / (c + eta * behind);
    return 0.5f * (across * across + along * along);
}

/// Both faces of a thin pane: 2R / (1 + R), all orders of inner reflection summed.
inline float paneReflectance(float c, float eta) {
    const float once = reflectance(c, eta);
    return 2 * once / (1 + once);
}

/// Schlick's approximation for a metal that reflects `straight` of what arrives head-on.
inline base::Vec3f metalReflectance(float c, const base::Vec3f& straight) {
    const float away = 1 - std::clamp(c, 0.0f, 1.0f), s = away * away * away * away * away;
    return straight + (base::Vec3f{1, 1, 1} - straight) * s;
}

/// Beer's law: the part of the light that is left after a way through glass.
inline base::Vec3f transmitted(const base::Vec3f& absorption, float way) {
    return {std::exp(-absorption.x * way), std::exp(-absorption.y * way), std::exp(-absorption.z * way)};
}

inline base::Vec3f times(const base::Vec3f& a, const base::Vec3f& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}

} // namespace raycast
