#include "ui/work/floaters.h"

#include "core/render/splats/splat_style.h"

namespace ui {

Snapshot withFloaters(const Snapshot& before, const reduce::Sites& floaters) {
    constexpr float wide = 0.3f, above = 0.05f; // radius and height of a disc, of the room that its sample has
    const auto layout = std::make_shared<surfel::AttributeLayout>(*before.whole.layout());
    layout->masks = true; // that these are seen by
    const float perSupport = render::splatRadiusOfSupport * before.splatScale;
    tree::Edit edit;
    edit.inserted.layout = layout;
    const std::vector<std::uint32_t> words(layout->words(), 0);
    for (std::size_t i = 0; i < floaters.size(); ++i) {
        const float room = floaters.spacing[i];
        surfel::Surfel disc;
        disc.normal = floaters.normal[i];
        disc.position = floaters.position[i] + (layout->oriented ? disc.normal * (above * room) : base::Vec3f{});
        disc.support = wide * room / perSupport;
        disc.mask = 1;
        edit.inserted.append(disc, words);
    }
    Snapshot out = before;
    out.whole = before.whole.withLayout(layout).apply(edit);
    return out;
}

} // namespace ui
