#include "core/render/framed_box.h"

#include <array>

namespace render {

constexpr std::size_t mostLookedAt = 65536;
constexpr double leftOut = 0.0025; ///< at either end of an axis
constexpr float farAway = 2;       ///< diagonals over each other
constexpr float around = 0.25f;    ///< of the diagonal: what stands so near to the box belongs to the model

template <class Fn>
static void forPositions(const tree::SurfelTree& tree, std::size_t step, const Fn& fn) {
    std::size_t at = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            if (at++ % step == 0)
                fn(block.position(slot));
    });
}

/// Between the quantiles of each axis.
static base::Box3f inner(const tree::SurfelTree& tree) {
    std::array<std::vector<float>, 3> values;
    forPositions(tree, tree.size() / mostLookedAt + 1, [&](const base::Vec3f& p) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            values[axis].push_back(p[axis]);
    });
    base::Box3f out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<float>& v = values[axis];
        const auto few = static_cast<std::ptrdiff_t>(leftOut * static_cast<double>(v.size()));
        std::nth_element(v.begin(), v.begin() + few, v.end());
        out.lo[axis] = v[static_cast<std::size_t>(few)];
        std::nth_element(v.begin(), v.end() - 1 - few, v.end());
        out.hi[axis] = *(v.end() - 1 - few);
    }
    return out;
}

base::Box3f framedBox(const tree::SurfelTree& tree) {
    const base::Box3f all = tree.bounds();
    if (tree.empty())
        return all;
    const base::Box3f most = inner(tree);
    if (!(most.diagonal() > 0) || all.diagonal() <= farAway * most.diagonal())
        return all;
    const base::Box3f near = most.inflated(around * most.diagonal());
    base::Box3f out;
    forPositions(tree, 1, [&](const base::Vec3f& p) {
        if (near.contains(p))
            out.extend(p);
    });
    return out;
}

} // namespace render
