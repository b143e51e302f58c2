#include "core/sculpt/tools/twist.h"

#include "core/sculpt/tools/deform.h"

#include <algorithm>

namespace sculpt {

namespace {

/// Taylor polynomials: to float precision for |x| <= 1, and in vector registers.
float sineOf(float x) {
    const float q = x * x;
    return x * (1 - q * (1.0f / 6) * (1 - q * (1.0f / 20) * (1 - q * (1.0f / 42) * (1 - q * (1.0f / 72)))));
}
/// 1 - cos x
float versineOf(float x) {
    const float q = x * x;
    return 0.5f * q * (1 - q * (1.0f / 12) * (1 - q * (1.0f / 30) * (1 - q * (1.0f / 56) * (1 - q * (1.0f / 90)))));
}

} // namespace

static tree::Edit twist(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = std::clamp(dab.strength * dab.angle, -1.0f, 1.0f);
    if (full == 0)
        return {};
    const base::Vec3f n = dab.areaNormal;
    const base::Mat3f turn{{{0, -n.z, n.y}, {n.z, 0, -n.x}, {-n.y, n.x, 0}}}; // n x
    const base::Mat3f flat = base::Mat3f::identity() - outer(n, n);
    return deform(version.tree(), brush, [&](const LanePlace&, const BrushLanes& at, ShiftLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes], sine[lanes], versine[lanes];
        brush.fade(at, weight, gradient);
        for (std::size_t i = 0; i < lanes; ++i)
            sine[i] = sineOf(full * weight[i]), versine[i] = versineOf(full * weight[i]);
        const float* p[3] = {at.x, at.y, at.z};
        for (std::size_t a = 0; a < 3; ++a) {
            alignas(64) float across[lanes], round[lanes], speed[lanes];
            for (std::size_t i = 0; i < lanes; ++i) {
                across[i] = flat.m[a][0] * at.x[i] + flat.m[a][1] * at.y[i] + flat.m[a][2] * at.z[i];
                round[i] = turn.m[a][0] * at.x[i] + turn.m[a][1] * at.y[i] + turn.m[a][2] * at.z[i];
                out.d[a][i] = sine[i] * round[i] - versine[i] * across[i];
                speed[i] = (1 - versine[i]) * round[i] - sine[i] * across[i]; // n x Rot t
            }
            for (std::size_t b = 0; b < 3; ++b)
                for (std::size_t i = 0; i < lanes; ++i)
                    out.j[a][b][i] =
                        sine[i] * turn.m[a][b] - versine[i] * flat.m[a][b] + speed[i] * full * gradient[i] * p[b][i];
        }
    });
}

const ToolRow twistTool{"twist",
                        "Twist",
                        "icons/tool-twist.svg",
                        "",
                        "Turns the surface as the pointer turns about the first contact.",
                        Motion::Turn,
                        1.0,
                        {},
                        twist};

} // namespace sculpt
