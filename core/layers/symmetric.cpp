#include "core/layers/symmetric.h"

#include "core/base/parallel.h"
#include "core/layers/settle_block.h"
#include "core/layers/surfel_layers.h"

namespace layers {

using base::Vec3d;
using surfel::MutableBlockPtr, surfel::SurfelBlock;

/// Blocks on one thread in a row.
constexpr std::size_t grain = 16;
/// Supports: so near to the plane surfels lie on it and have no image.
constexpr double onPlane = 1e-3;

/// An image is reflected; what lies on the plane loses what leads away from it.
static void makeSymmetric(SurfelLayers& words, const base::Plane& plane, bool image) {
    const auto made = [&](const Vec3d& v) { return v - plane.normal * ((image ? 2 : 1) * dot(plane.normal, v)); };
    words.base = words.base - plane.normal * ((image ? 2 : 1) * plane.distance(words.base));
    words.normal = image ? made(words.normal) : normalized(made(words.normal), words.normal);
    for (SurfelLayers::Part& part : words.parts)
        part.d = made(part.d), part.e = made(part.e);
}

static MutableBlockPtr madeSymmetric(const SurfelBlock& block, const SettleRules& rules, const base::Plane& plane) {
    MutableBlockPtr out = block.clone();
    SurfelLayers words;
    for (int slot = 0; slot < out->size(); ++slot) {
        const double height = plane.distance(base::cast<double>(out->position(slot))),
                     rounding = onPlane * static_cast<double>(out->support(slot));
        if (height > rounding)
            continue;
        words.read(*out, slot, rules.channels);
        makeSymmetric(words, plane, height < -rounding);
        words.write(*out, slot, rules.channels);
    }
    settle(*out, rules, nullptr);
    out->seal();
    return out;
}

tree::SurfelTree symmetric(const tree::SurfelTree& after, const Stack& stack, const base::Plane& plane) {
    const auto channels = Channels::of(*after.layout(), stack);
    if (stack.empty() || !channels)
        return after;
    const SettleRules rules{*channels, weightsOf(stack), -1, How::Keep};
    tree::Edit edit;
    edit.blocks.resize(after.blockCount());
    base::parallelFor(edit.blocks.size(), grain, [&](std::size_t b) {
        const auto number = static_cast<std::uint32_t>(b);
        edit.blocks[b] = {number, madeSymmetric(*after.block(number), rules, plane), {}};
    });
    return after.apply(edit);
}

} // namespace layers
