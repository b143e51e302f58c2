#include "core/sculpt/tools/paint.h"

#include "core/sculpt/tools/brush.h"
#include "core/sculpt/tools/colours.h"
#include "core/sculpt/tools/layout_flags.h"

#include <algorithm>

namespace sculpt {

constexpr ToolParameter parameters[] = {
    {"colour", "Colour", "rgb", "What is painted, as 65536 red + 256 green + blue.", 0xc8553d, 0, 0xffffff},
    {"colour2", "Second colour", "rgb", "What is painted when inverted.", 0xf4efe6, 0, 0xffffff},
};

static tree::Edit paint(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float full = std::min(1.0f, std::abs(dab.strength));
    if (full == 0)
        return {};
    const surfel::Colour colour = colourOf(dab.parameters.at(dab.strength < 0 ? "colour2" : "colour"));
    const std::uint32_t seed = roundingSeed(dab);
    tree::Edit edit =
        changeClusters(blocksUnder(version.tree(), brush.centre, brush.radius), brush,
                       [&](const BrushBlock& in, std::size_t, int cluster, surfel::MutableBlockPtr& changed) {
                           alignas(64) float weight[lanes];
                           if (!brush.weigh(in, cluster, weight))
                               return;
                           const std::uint32_t* old = in.block->words(cluster, surfel::ColourWord);
                           surfel::Colour next[lanes];
                           for (std::size_t i = 0; i < lanes; ++i)
                               next[i] = weight[i] == 0
                                             ? old[i]
                                             : mixed(old[i], colour, full * weight[i],
                                                     in.block->position(cluster * surfel::clusterSize + int(i)), seed);
                           if (std::equal(next, next + lanes, old))
                               return;
                           if (!changed)
                               changed = in.block->clone();
                           std::copy(next, next + lanes, changed->words(cluster, surfel::ColourWord));
                       });
    if (!edit.empty())
        edit.layout = withFlag(version.tree().layout(), &surfel::AttributeLayout::colours);
    return edit;
}

const ToolRow paintTool{"paint",
                        "Paint",
                        "icons/tool-paint.svg",
                        "",
                        "Colours the surface; inverted, with the second colour.",
                        Motion::Along,
                        0.5,
                        parameters,
                        paint,
                        Writes::Colour};

} // namespace sculpt
