#include "core/process/estimation/spacing_sample.h"

#include "core/base/scratch.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/spacing.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace process {

constexpr std::size_t ring = 6;
/// Asked for, so that a cloud with every point twice still gives a ring.
constexpr std::size_t looked = 2 * (ring + 1);
constexpr std::uint32_t sampledBlocks = 256;

float spacingFromRing(std::span<const float> distancesSq) {
    double sum = 0;
    std::size_t count = 0;
    for (const float sq : distancesSq)
        if (sq > 0 && count < ring) {
            sum += std::sqrt(static_cast<double>(sq));
            ++count;
        }
    return count ? static_cast<float>(spacingOverDistance * sum / static_cast<double>(count)) : 0.0f;
}

/// Spacing at a surfel: coincident ones count once.
static float spacingAt(const std::vector<tree::Neighbour>& found) {
    std::vector<float> distancesSq;
    std::vector<base::Vec3f> seen;
    for (const tree::Neighbour& n : found) {
        const base::Vec3f p = n.block->position(n.slot);
        if (std::find(seen.begin(), seen.end(), p) != seen.end())
            continue;
        seen.push_back(p);
        distancesSq.push_back(n.distanceSq);
    }
    return spacingFromRing(distancesSq);
}

float spacingAround(const tree::SurfelTree& tree, const base::Vec3f& x) {
    static base::Scratch<std::vector<tree::Neighbour>> scratch;
    const auto found = scratch.take();
    tree.nearest(x, looked, *found); // itself among them
    return spacingAt(*found);
}

std::vector<SpacingSample> sampleSpacing(const tree::SurfelTree& tree) {
    std::vector<SpacingSample> out;
    if (tree.size() <= ring)
        return out;
    const int shape = surfel::shapeChannel(*tree.layout());
    const std::uint32_t step = std::max(1u, tree.blockCount() / sampledBlocks);
    for (std::uint32_t number = 0; number < tree.blockCount(); number += step) {
        const surfel::BlockPtr block = tree.block(number);
        const int slot = block->size() / 2;
        if (const float spacing = spacingAround(tree, block->position(slot)); spacing > 0)
            out.push_back({spacing, surfel::ballOf(*block, slot, shape)});
    }
    return out;
}

float typicalSpacing(const tree::SurfelTree& tree) {
    std::vector<float> spacings;
    for (const SpacingSample& each : sampleSpacing(tree))
        spacings.push_back(each.spacing);
    return summarise(std::move(spacings)).median;
}

} // namespace process
