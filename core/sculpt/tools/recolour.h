// The one way in which tools change colours: towards what they ask for, as far as strength, brush and mask let them.
#pragma once

#include "core/sculpt/tools/brush.h"
#include "core/sculpt/tools/colours.h"

#include <algorithm>

namespace sculpt {

/// Moves the colours under the brush towards target(block, slot, colour), the last being that of the slot.
template <class Target>
tree::Edit recolour(const tree::SurfelTree& version, const Dab& dab, const Brush& brush, const Target& target) {
    const float full = std::min(1.0f, std::abs(dab.strength));
    const std::uint32_t seed = roundingSeed(dab);
    return changeClusters(blocksUnder(version, brush.centre, brush.radius), brush,
                          [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                              alignas(64) float weight[lanes];
                              if (!brush.weigh(in, cluster, weight))
                                  return;
                              const std::uint32_t* old = in.block->words(cluster, surfel::ColourWord);
                              surfel::Colour next[lanes];
                              for (std::size_t i = 0; i < lanes; ++i) {
                                  const int slot = cluster * surfel::clusterSize + int(i);
                                  next[i] = weight[i] == 0 ? old[i]
                                                           : mixed(old[i], target(*in.block, slot, old[i]),
                                                                   full * weight[i], in.block->position(slot), seed);
                              }
                              if (std::equal(next, next + lanes, old))
                                  return;
                              if (!changed)
                                  changed = in.block->clone();
                              std::copy(next, next + lanes, changed->words(cluster, surfel::ColourWord));
                          });
}

} // namespace sculpt
