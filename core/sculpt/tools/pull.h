// The weight with which matter follows a pull, taken half way: w(p) = W(|(p + p')/2 - (centre + m/2)| / R), where
// p' = p + m w(p). Grab says why; W is the brush's falloff with its plateau. REQUIRES: brush.centre is half way itself.
#pragma once

#include "core/sculpt/tools/displace.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// A Field of `displace` with direction m.
struct Pull {
    /// Newton steps until the weight stands still to float precision: the first error is below 0.1 and squares each
    /// time.
    static constexpr int iterations = 3;
    /// Keeps the Jacobian finite at the vertical rims of some falloffs.
    static constexpr float leastSlope = 0.25f;

    Brush brush;
    base::Vec3f m;

    /// Half-way places for given weights: p + m w/2, seen from the brush's centre, which is half way itself.
    void halfWay(const BrushLanes& at, const float* weight, BrushLanes& out) const {
        const float scale = 1 / brush.radius;
        for (std::size_t i = 0; i < lanes; ++i) {
            const float half = 0.5f * weight[i];
            out.x[i] = at.x[i] + m.x * half, out.y[i] = at.y[i] + m.y * half, out.z[i] = at.z[i] + m.z * half;
            out.r[i] = std::sqrt(out.x[i] * out.x[i] + out.y[i] * out.y[i] + out.z[i] * out.z[i]) * scale;
        }
    }

    /// One Newton step of w - W(half-way place) = 0; leaves g = k / (1 - k.m/2) in `out`.
    void improve(const BrushLanes& half, AmountLanes& out) const {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(half, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i) {
            const float kx = gradient[i] * half.x[i], ky = gradient[i] * half.y[i], kz = gradient[i] * half.z[i];
            const float scale = 1 / std::max(leastSlope, 1 - 0.5f * (kx * m.x + ky * m.y + kz * m.z));
            out.amount[i] = std::clamp(out.amount[i] + (weight[i] - out.amount[i]) * scale, 0.0f, 1.0f);
            out.gx[i] = kx * scale, out.gy[i] = ky * scale, out.gz[i] = kz * scale;
        }
    }

    void operator()(const BrushLanes& at, AmountLanes& out) const {
        alignas(64) float gradient[lanes];
        BrushLanes half;
        brush.fade(at, out.amount, gradient);
        for (int k = 0; k < iterations; ++k) {
            halfWay(at, out.amount, half);
            improve(half, out);
        }
    }
};

} // namespace sculpt
