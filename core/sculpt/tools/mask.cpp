#include "core/sculpt/tools/mask.h"

#include "core/sculpt/tools/brush.h"
#include "core/sculpt/tools/layout_flags.h"

#include <algorithm>

namespace sculpt {

/// What a dab of full strength adds.
constexpr float pace = 0.5f;

static tree::Edit mask(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = dab.strength * pace;
    if (full == 0)
        return {};
    tree::Edit edit =
        changeClusters(blocksUnder(version.tree(), brush.centre, brush.radius), brush,
                       [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                           alignas(64) float weight[lanes];
                           if (!brush.weigh(in, cluster, weight, false))
                               return;
                           const float* old = in.block->channel(cluster, surfel::Mask);
                           alignas(64) float next[lanes];
                           bool any = false;
                           for (std::size_t i = 0; i < lanes; ++i) {
                               next[i] = std::min(1.0f, std::max(0.0f, old[i] + full * weight[i]));
                               any |= next[i] != old[i];
                           }
                           if (!any)
                               return;
                           if (!changed)
                               changed = in.block->clone();
                           std::copy(next, next + lanes, changed->channel(cluster, surfel::Mask));
                       });
    if (!edit.empty())
        edit.layout = withFlag(version.tree().layout(), &surfel::AttributeLayout::masks);
    return edit;
}

const ToolRow maskTool{"mask",
                       "Mask",
                       "icons/tool-mask.svg",
                       "M",
                       "Protects what it is painted on from all other tools; inverted, frees it.",
                       Motion::Along,
                       1.0,
                       {},
                       mask,
                       Writes::Mask};

} // namespace sculpt
