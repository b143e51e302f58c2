#include "core/sculpt/tools/smear.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/brush.h"
#include "core/sculpt/tools/colours.h"
#include "core/surface/attribute_sum.h"
#include "core/surface/weights.h"

namespace sculpt {

/// C(x); `fallback` where nothing has weight.
static surfel::Colour colourAround(const surface::Surface& version, const base::Vec3f& x, const base::Vec3f& normal,
                                   surfel::Colour fallback) {
    const bool oriented = version.tree().layout()->oriented;
    surface::AttributeSum sum(*surfel::AttributeLayout::none());
    surface::forWeights(version, x, [&](const surfel::SurfelBlock& block, int slot, float theta) {
        if (!oriented || dot(block.normal(slot), normal) >= 0)
            sum.add(block, slot, theta);
    });
    return sum.any() ? sum.colour() : fallback;
}

static tree::Edit smear(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = std::min(1.0f, std::abs(dab.strength));
    const base::Vec3f m = alongSurface(dab) * (dab.strength < 0 ? -1.0f : 1.0f);
    if (full == 0 || m == base::Vec3f{} || !version.tree().layout()->colours)
        return {};
    const std::uint32_t seed = roundingSeed(dab);
    return changeClusters(blocksUnder(version.tree(), brush.centre, brush.radius), brush,
                          [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                              alignas(64) float weight[lanes];
                              if (!brush.weigh(in, cluster, weight))
                                  return;
                              const std::uint32_t* old = in.block->words(cluster, surfel::ColourWord);
                              surfel::Colour next[lanes];
                              for (std::size_t i = 0; i < lanes; ++i) {
                                  next[i] = old[i];
                                  if (weight[i] == 0)
                                      continue;
                                  const int slot = cluster * surfel::clusterSize + int(i);
                                  const base::Vec3f p = in.block->position(slot);
                                  next[i] = mixed(old[i], colourAround(version, p - m, in.block->normal(slot), old[i]),
                                                  full * weight[i], p, seed);
                              }
                              if (std::equal(next, next + lanes, old))
                                  return;
                              if (!changed)
                                  changed = in.block->clone();
                              std::copy(next, next + lanes, changed->words(cluster, surfel::ColourWord));
                          });
}

const ToolRow smearTool{
    "smear", "Smear", "icons/tool-smear.svg", "", "Drags colours along the way the stroke goes.", Motion::Follow, 1.0,
    {},      smear,   Writes::Colour};

} // namespace sculpt
