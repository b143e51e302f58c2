#include "core/sculpt/tools/smear.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/brush.h"
#include "core/sculpt/tools/colours.h"

namespace sculpt {

/// C(x); `fallback` where nothing has weight.
static surfel::Colour colourAround(const tree::SurfelTree& tree, const base::Vec3f& x, const base::Vec3f& normal,
                                   surfel::Colour fallback) {
    float sum[4] = {}, total = 0;
    const bool oriented = tree.layout()->oriented;
    tree.forClustersInSupport(x, [&](const surfel::SurfelBlock& block, int cluster) {
        const int end = std::min(block.size(), (cluster + 1) * surfel::clusterSize);
        for (int slot = cluster * surfel::clusterSize; slot < end; ++slot) {
            const float h = block.support(slot), distSq = distanceSq(block.position(slot), x);
            if (distSq >= h * h || (oriented && dot(block.normal(slot), normal) < 0))
                continue;
            const float r = std::sqrt(distSq) / h, t = (1 - r) * (1 - r), w = t * t * (4 * r + 1);
            const surfel::Colour c = block.words(cluster, surfel::ColourWord)[slot % surfel::clusterSize];
            for (unsigned k = 0; k < 4; ++k)
                sum[k] += w * static_cast<float>(c >> (8 * k) & 255u);
            total += w;
        }
    });
    if (!(total > 0))
        return fallback;
    surfel::Colour out = 0;
    for (unsigned k = 0; k < 4; ++k)
        out |= static_cast<surfel::Colour>(std::lround(sum[k] / total)) << (8 * k);
    return out;
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
                                  next[i] =
                                      mixed(old[i], colourAround(version.tree(), p - m, in.block->normal(slot), old[i]),
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
