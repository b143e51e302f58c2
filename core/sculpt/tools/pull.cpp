#include "core/sculpt/tools/pull.h"

#include "core/base/clones.h"

#include <cmath>

namespace sculpt {

/// Newton steps until the weight stands still to float precision: the first error is below 0.1 and squares each time.
constexpr int iterations = 3;
/// Keeps the Jacobian finite at the vertical rims of some falloffs.
constexpr float leastSlope = 0.25f;

/// Half-way places for given weights: p + m w/2, seen from the brush's centre, which is half way itself.
POINTCLAY_CLONES
static void halfWay(const BrushLanes& at, const base::Vec3f& m, float scale, const float* __restrict weight,
                    BrushLanes& __restrict out) {
    const float mx = m.x, my = m.y, mz = m.z;
    for (std::size_t i = 0; i < lanes; ++i) {
        const float half = 0.5f * weight[i];
        const float x = at.x[i] + mx * half, y = at.y[i] + my * half, z = at.z[i] + mz * half;
        out.x[i] = x, out.y[i] = y, out.z[i] = z;
        out.r[i] = std::sqrt(x * x + y * y + z * z) * scale;
    }
}

/// One Newton step of w - W(half-way place) = 0; leaves g = k / (1 - k.m/2) in `out`.
POINTCLAY_CLONES
static void improve(const BrushLanes& half, const base::Vec3f& m, const float* __restrict weight,
                    const float* __restrict gradient, AmountLanes& __restrict out) {
    const float mx = m.x, my = m.y, mz = m.z;
    for (std::size_t i = 0; i < lanes; ++i) {
        const float kx = gradient[i] * half.x[i], ky = gradient[i] * half.y[i], kz = gradient[i] * half.z[i];
        const float slope = 1 - 0.5f * (kx * mx + ky * my + kz * mz);
        const float scale = 1 / (slope < leastSlope ? leastSlope : slope);
        const float amount = out.amount[i] + (weight[i] - out.amount[i]) * scale;
        const float above = amount < 0 ? 0.0f : amount;
        out.amount[i] = above > 1 ? 1.0f : above;
        out.gx[i] = kx * scale, out.gy[i] = ky * scale, out.gz[i] = kz * scale;
    }
}

void Pull::operator()(const BrushLanes& at, AmountLanes& out) const {
    alignas(64) float weight[lanes], gradient[lanes];
    BrushLanes half;
    brush.fade(at, out.amount, gradient);
    for (int k = 0; k < iterations; ++k) {
        halfWay(at, m, 1 / brush.radius, out.amount, half);
        brush.fade(half, weight, gradient);
        improve(half, m, weight, gradient, out);
    }
}

} // namespace sculpt
