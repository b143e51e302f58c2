#include "core/sculpt/tools/grab.h"

#include "core/sculpt/tools/displace.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Newton steps until the weight stands still to float precision: the first error is below 0.1 and squares each time.
constexpr int iterations = 3;
/// Keeps the Jacobian finite at the vertical rims of some falloffs.
constexpr float steepest = 0.25f;

constexpr ToolParameter parameters[] = {
    {"plateau", "Plateau", "radii", "Part of the brush that moves as one piece.", 0.25, 0.15, 0.5},
};

namespace {

struct Pull {
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
            const float scale = 1 / std::max(steepest, 1 - 0.5f * (kx * m.x + ky * m.y + kz * m.z));
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

} // namespace

static tree::Edit grab(const surface::Surface& version, const Dab& dab) {
    Brush brush(dab);
    brush.plateau = dab.parameter("plateau");
    const base::Vec3f m = dab.move * std::abs(dab.strength);
    if (m == base::Vec3f{})
        return {};
    brush.centre += m * 0.5f; // all weights are taken half way
    return displace(version.tree(), brush, m, Pull{brush, m});
}

const ToolRow grabTool{"grab",
                       "Grab",
                       "icons/tool-grab.svg",
                       "G",
                       "Holds what was touched first and carries it with the pointer.",
                       Motion::Drag,
                       1.0,
                       parameters,
                       grab};

} // namespace sculpt
