#include "core/render/effects/effect_table.h"

#include "core/base/row_of_id.h"

#include <algorithm>

namespace render {

std::span<const EffectRow> effectTable() {
    static constexpr EffectRow rows[] = {
        {EyeDome, "eye-dome", "Eye-Dome Lighting", "Darkens grooves and what lies behind an edge"},
        {Occlusion, "ambient-occlusion", "Ambient Occlusion", "Shadows where little of the sky can be seen"},
        {Outline, "outline", "Outlines", "Lines where the surface ends before something farther away"},
        {Creases, "creases", "Creases", "Lines along sharp edges"},
        {Contours, "contours", "Suggestive Contours", "Lines that would become outlines if the eye moved a little"},
    };
    return rows;
}

Effects effects(std::string_view list) {
    Effects out = 0;
    while (!list.empty()) {
        const std::string_view id = list.substr(0, list.find(','));
        list.remove_prefix(std::min(list.size(), id.size() + 1));
        out |= base::rowOf(effectTable(), id, {"unknown effect '%'", "", "use some of: %"}).effect;
    }
    return out;
}

} // namespace render
