#include "core/sculpt/tools/smooth.h"

#include "core/sculpt/tools/gather.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

namespace {

/// One surfel towards the surface; false where there is no surface to go to.
bool settle(surfel::SurfelBlock& block, int slot, float share, const surface::Evaluationf& e) {
    const float slopeSq = lengthSq(e.gradient);
    if (e.status != surface::Status::Ok && e.status != surface::Status::BeyondBoundary)
        return false;
    if (!(slopeSq > 0.01f))
        return false;
    base::Vec3f normal = e.gradient / std::sqrt(slopeSq);
    // A step of more than the spacing comes from a fold, where f is no distance.
    const float limit = 0.25f * e.unit;
    const float step = std::clamp(e.value / std::sqrt(slopeSq), -limit, limit);
    block.setPosition(slot, block.position(slot) - normal * (share * step));
    const base::Vec3f old = block.normal(slot);
    if (dot(normal, old) < 0)
        normal = -normal;
    if (old != base::Vec3f{})
        block.setNormal(slot, normalized(old * (1 - share) + normal * share, old));
    return true;
}

} // namespace

static tree::Edit smooth(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float strength = std::abs(dab.strength);
    if (strength == 0)
        return {};
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const Gathered list = gather(blocks, brush);
    surface::SurfaceDefinition definition = version.definition();
    definition.shrinkFree = true;
    std::vector<surface::Evaluationf> at(list.places.size());
    surface::Surface(version.tree(), definition).evaluate(list.places, surface::Need::Gradient, at);
    return changeBlocks(blocks, [&](const BrushBlock& in, std::size_t b) -> surfel::BlockPtr {
        if (list.first[b] == list.first[b + 1])
            return {};
        surfel::MutableBlockPtr changed = in.block->clone();
        bool moved = false;
        for (std::size_t i = list.first[b]; i < list.first[b + 1]; ++i)
            moved |= settle(*changed, list.slots[i], strength * list.weight[i] * list.free[i], at[i]);
        if (!moved)
            return {};
        changed->seal();
        return changed;
    });
}

const ToolRow smoothTool{"smooth",
                         "Smooth",
                         "icons/tool-smooth.svg",
                         "S",
                         "Evens out relief under the brush and keeps the shape's size.",
                         Motion::Along,
                         0.5,
                         {},
                         smooth};

} // namespace sculpt
