#include "core/sculpt/tools/morph.h"

#include "core/layers/shown_cluster.h"
#include "core/sculpt/tools/brush.h"

#include <algorithm>

namespace sculpt {

/// Part of the way to the surfel of `shape` in that lane.
static void blend(surfel::SurfelBlock& block, int slot, const layers::ShownCluster& shape, std::size_t lane, float t) {
    const auto at = [lane](const float(&of)[3][lanes]) { return base::Vec3f{of[0][lane], of[1][lane], of[2][lane]}; };
    const base::Vec3f p = block.position(slot), n = block.normal(slot);
    block.setPosition(slot, p + (at(shape.position) - p) * t);
    block.setNormal(slot, normalized(n * (1 - t) + at(shape.normal) * t, n));
    const float h = block.support(slot);
    block.channel(slot / surfel::clusterSize, surfel::Support)[lane] =
        h + (shape.support[lane] - h) * std::clamp(t, 0.0f, 1.0f);
}

static tree::Edit morph(const surface::Surface& version, const Dab& dab) {
    if (!dab.layers || dab.layers->target() < 0 || dab.strength == 0)
        return {};
    const auto channels = layers::Channels::of(*version.tree().layout(), *dab.layers);
    if (!channels)
        return {};
    std::vector<float> weights = layers::weightsOf(*dab.layers);
    weights[static_cast<std::size_t>(dab.layers->target())] = 0;
    const Brush brush(dab);
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    return changeClusters(blocks, brush,
                          [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                              alignas(64) float share[lanes];
                              if (!brush.weigh(in, cluster, share))
                                  return;
                              layers::ShownCluster shape;
                              layers::show(*in.block, cluster, *channels, weights, shape);
                              for (std::size_t lane = 0; lane < lanes; ++lane) {
                                  const int slot = cluster * surfel::clusterSize + static_cast<int>(lane);
                                  if (share[lane] == 0 || shape.agrees(*in.block, cluster, static_cast<int>(lane)))
                                      continue;
                                  if (!changed)
                                      changed = in.block->clone();
                                  blend(*changed, slot, shape, lane, share[lane] * dab.strength);
                              }
                          });
}

const ToolRow morphTool{"morph",
                        "Morph",
                        "icons/tool-morph.svg",
                        "Shift+Y",
                        "Brings the surface back to what it was when the active layer began; inverted, away from it.",
                        Motion::Along,
                        0.5,
                        {},
                        morph,
                        Writes::Surface,
                        {.layer = true}};

} // namespace sculpt
