#include "core/solid/seam_feet.h"

#include "core/base/parallel.h"
#include "core/cells/labels.h"
#include "core/surfel/shape.h"

#include <optional>

namespace solid {

using base::Vec3d;

namespace {

/// Spacings: cells::partnerReach.
constexpr double reach = 2;

std::optional<Vec3d> seamFoot(const TwoSides& sides, const Vec3d& x, float support) {
    const double spacing = static_cast<double>(support) * surface::spacingOfUnit;
    for (const auto* side : {&sides.a, &sides.b})
        if (const SideValue at = (*side)(x); !at.near || std::abs(at.value) >= 2 * reach * spacing)
            return {};
    const std::optional<SeamPoint> found = seamPoint(sides, x, seamTolerance * spacing);
    if (!found || distance(found->position, x) > reach * spacing)
        return {};
    return found->position;
}

} // namespace

SeamFeet seamFeetOf(const tree::SurfelTree& version, const TwoSides& sides, const Side& other,
                    const std::function<bool(std::size_t index)>& stays) {
    SeamFeet out(version.blockCount());
    const std::vector<std::size_t> first = version.firstSurfels();
    const int shape = surfel::shapeChannel(*version.layout());
    const auto labels = cells::LabelLayout::of(*version.layout());
    base::parallelFor(out.size(), 1, [&](std::size_t b) {
        const surfel::BlockPtr block = version.block(static_cast<std::uint32_t>(b));
        const base::Box3f box = block->box().inflated(2 * block->maxSupport());
        if (!other.meets({base::cast<double>(box.lo), base::cast<double>(box.hi)}))
            return;
        for (int slot = 0; slot < block->size(); ++slot) {
            const std::size_t index = first[b] + static_cast<std::size_t>(slot);
            if (!stays(index))
                continue;
            const float support = block->support(slot);
            if (const auto foot = seamFoot(sides, base::cast<double>(block->position(slot)), support))
                out[b].push_back({index, *foot,
                                  static_cast<double>(surfel::ballOf(*block, slot, shape)) * surface::spacingOfUnit,
                                  labels ? labels->cellAt(*block, slot) : 0});
        }
    });
    return out;
}

} // namespace solid
