#include "core/sculpt/tools/smear.h"

#include "core/sculpt/tools/along_surface.h"
#include "core/sculpt/tools/recolour.h"
#include "core/surface/evaluation/attribute_sum.h"
#include "core/surface/evaluation/weights.h"

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
    const base::Vec3f m = alongSurface(dab) * (dab.strength < 0 ? -1.0f : 1.0f);
    if (dab.strength == 0 || m == base::Vec3f{} || !version.tree().layout()->colours)
        return {};
    return recolour(version.tree(), dab, Brush(dab),
                    [&](const surfel::SurfelBlock& block, int slot, surfel::Colour old) {
                        return colourAround(version, block.position(slot) - m, block.normal(slot), old);
                    });
}

const ToolRow smearTool{
    "smear", "Smear", "icons/tool-smear.svg", "", "Drags colours in the direction of the stroke.", Motion::Follow, 1.0,
    {},      smear,   Writes::Colour};

} // namespace sculpt
