#include "core/cells/creases/labelled_surface.h"

#include "core/base/error.h"
#include "core/surface/definition_text.h"
#include "core/tree/with_surfels.h"

#include <algorithm>
#include <array>

namespace cells {

void requireSides(const surface::Surface& surface) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " has no creases of this kind", {},
                          "open it as a surface");
    if (surface.tree().empty())
        throw base::Error("there is nothing to crease");
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    if (!layout.normals || !layout.oriented)
        throw base::Error("the normals do not tell inside from outside", {}, "orient them first (\"orient\")");
}

std::vector<Label> labelsOf(const tree::SurfelTree& tree) {
    std::vector<Label> out(tree.size());
    const auto layout = LabelLayout::of(*tree.layout());
    if (!layout)
        return out;
    std::size_t next = 0;
    tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            out[next++] = layout->at(block, slot);
    });
    return out;
}

surface::Surface labelled(const surface::Surface& surface, surfel::SurfelList surfels, std::span<const Label> labels) {
    requireNames(*surfels.layout);
    setLabels(surfels, labels);
    return {tree::withSurfels(surface.tree(), surfels), surface.definition()};
}

surface::Surface unlabelled(const surface::Surface& surface) {
    const surfel::SurfelList before = surface.tree().surfels();
    if (!LabelLayout::of(*before.layout))
        return surface;
    constexpr std::array<std::string_view, 5> ours{"cell", "partner", "sign", "sharpness", "face"};
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = before.layout->normals;
    layout->oriented = before.layout->oriented;
    layout->colours = before.layout->colours;
    layout->masks = before.layout->masks;
    std::vector<std::size_t> kept; // words
    for (const surfel::Attribute& each : before.layout->attributes())
        if (surfel::isReal(each.type) || std::find(ours.begin(), ours.end(), each.name) == ours.end()) {
            layout->add(each.name, each.type);
            for (std::size_t w = 0; w < surfel::wordsOf(each.type); ++w)
                kept.push_back(each.firstWord + w);
        }
    surfel::SurfelList after;
    after.layout = layout;
    after.items = before.items;
    for (std::size_t i = 0; i < before.size(); ++i)
        for (const std::size_t word : kept)
            after.extra.push_back(before.extraOf(i)[word]);
    return {tree::withSurfels(surface.tree(), after), surface.definition()};
}

} // namespace cells
