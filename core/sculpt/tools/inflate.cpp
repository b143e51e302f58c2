#include "core/sculpt/tools/inflate.h"

#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"

#include <algorithm>

namespace sculpt {

/// Height of a dab of full strength, in radii.
constexpr float height = 0.05f;

static bool known(const surface::Evaluationf& e) {
    return e.status == surface::Status::Ok || e.status == surface::Status::BeyondBoundary;
}

/// Agreement of the summed normals of both sides below which a thin place is as thin as it gets, and above which it has
/// room to shrink.
constexpr float closed = 0.75f, open = 0.95f;

/// How much of its way, `step` inwards, each place may go: what shrinks stops before its sides meet. The other side
/// comes as far, so that the surface is asked a step and two steps below.
static std::vector<float> brakes(const surface::Surface& version, std::span<const base::Vec3f> places,
                                 std::span<const surface::Evaluationf> at, float step) {
    surface::SurfaceDefinition definition = version.definition();
    definition.oneSheet = false; // the other side must have its say
    const surface::Surface both(version.tree(), definition);
    std::vector<float> out(places.size(), 1.0f);
    std::vector<base::Vec3f> below(places.size());
    std::vector<surface::Evaluationf> e(places.size());
    for (const float depth : {step, 2 * step}) {
        for (std::size_t i = 0; i < places.size(); ++i)
            below[i] = places[i] - at[i].normal * depth;
        both.evaluate(below, surface::Need::Value, e);
        for (std::size_t i = 0; i < places.size(); ++i)
            if (e[i].samples > 0)
                out[i] = std::min(out[i], (dot(e[i].normal, at[i].normal) * e[i].agreement - closed) / (open - closed));
    }
    for (float& each : out)
        each = std::max(each, 0.0f);
    return out;
}

static tree::Edit inflate(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = dab.strength * height * dab.radius;
    if (full == 0)
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const Gathered list = gather(blocks, brush);
    std::vector<surface::Evaluationf> e(list.places.size());
    version.evaluate(list.places, surface::Need::Gradient, e);
    const std::vector<float> brake = full < 0 && dab.oriented ? brakes(version, list.places, e, -full)
                                                              : std::vector<float>(list.places.size(), 1.0f);
    return deform(version.tree(), blocks, brush, [&](const LanePlace& where, const BrushLanes& at, ShiftLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        out.clear();
        list.forCluster(where.index, where.cluster, [&](std::size_t i, std::size_t lane) {
            if (!known(e[i]))
                return;
            const base::Vec3f outwards = dab.oriented ? where.in.block->normal(list.slots[i]) : dab.areaNormal;
            const float side = (dot(outwards, e[i].normal) < 0 ? -full : full) * brake[i];
            if (side == 0)
                return;
            const base::Vec3f from{at.x[lane], at.y[lane], at.z[lane]};
            out.set(lane, e[i].normal * (side * weight[lane]),
                    outer(e[i].normal, from * (side * gradient[lane])) + e[i].normalGradient * (side * weight[lane]));
        });
    });
}

const ToolRow inflateTool{"inflate",
                          "Inflate",
                          "icons/tool-inflate.svg",
                          "I",
                          "Swells the surface along its own normals; inverted, shrinks it.",
                          Motion::Along,
                          0.5,
                          {},
                          inflate};

} // namespace sculpt
