#include "core/sculpt/tools/inflate.h"

#include "core/sculpt/tools/deform.h"
#include "core/sculpt/tools/gather.h"

namespace sculpt {

/// Height of a dab of full strength, in radii.
constexpr float height = 0.05f;

static bool known(const surface::Evaluationf& e) {
    return e.status == surface::Status::Ok || e.status == surface::Status::BeyondBoundary;
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
    return deform(version.tree(), blocks, brush, [&](const LanePlace& where, const BrushLanes& at, ShiftLanes& out) {
        alignas(64) float weight[lanes], gradient[lanes];
        brush.fade(at, weight, gradient);
        out.clear();
        list.forCluster(where.index, where.cluster, [&](std::size_t i, std::size_t lane) {
            if (!known(e[i]))
                return;
            const base::Vec3f outwards = dab.oriented ? where.in.block->normal(list.slots[i]) : dab.areaNormal;
            const float side = dot(outwards, e[i].normal) < 0 ? -full : full;
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
