#include "core/sculpt/tools/snake_hook.h"

#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/pull.h"

#include <cmath>

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"plateau", "Plateau", "radii", "Part of the brush that moves as one piece.", 0.4, 0.15, 0.8},
    {"taper", "Taper", "", "How much the horn thins (or, below 0, swells) on its way.", 0.1, -1.0, 1.0},
};

static tree::Edit snakeHook(const surface::Surface& version, const Dab& dab) {
    const Brush brush = [&] {
        Brush out(dab);
        out.plateau = dab.parameter("plateau");
        return out;
    }();
    const base::Vec3f m = dab.move * std::abs(dab.strength), u = normalized(m);
    if (m == base::Vec3f{})
        return {};
    Brush halfWay = brush;
    halfWay.centre += m * 0.5f;
    const Pull pull{halfWay, m};
    const base::Mat3f thin =
        (base::Mat3f::identity() - outer(u, u)) * (-dab.parameter("taper") * length(m) / dab.radius);
    return deform(version.tree(), halfWay, [&](const LanePlace& where, const BrushLanes& at, ShiftLanes& out) {
        AmountLanes along;
        pull(at, along);
        BrushLanes here;
        alignas(64) float weight[lanes], gradient[lanes];
        brush.place(*where.in.block, where.cluster, here);
        brush.fade(here, weight, gradient);
        const float *p[3] = {here.x, here.y, here.z}, *g[3] = {along.gx, along.gy, along.gz};
        for (std::size_t a = 0; a < 3; ++a) {
            alignas(64) float t[lanes];
            for (std::size_t i = 0; i < lanes; ++i)
                t[i] = thin.m[a][0] * here.x[i] + thin.m[a][1] * here.y[i] + thin.m[a][2] * here.z[i];
            for (std::size_t b = 0; b < 3; ++b)
                for (std::size_t i = 0; i < lanes; ++i)
                    out.j[a][b][i] = m[a] * g[b][i] + t[i] * gradient[i] * p[b][i] + weight[i] * thin.m[a][b];
            for (std::size_t i = 0; i < lanes; ++i)
                out.d[a][i] = m[a] * along.amount[i] + weight[i] * t[i];
        }
    });
}

const ToolRow snakeHookTool{"snake-hook",
                            "Snake Hook",
                            "icons/tool-snake-hook.svg",
                            "K",
                            "Pulls a piece of the surface out into a horn that follows the pointer.",
                            Motion::Drag,
                            1.0,
                            parameters,
                            snakeHook};

} // namespace sculpt
