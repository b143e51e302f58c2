#include "core/render/effects/effect_table.h"

#include "core/base/row_of_id.h"
#include "core/render/effects/effect_rows.h"

#include <algorithm>

namespace render {

static_assert([] {
    for (std::size_t i = 0; i < effectCount; ++i)
        if (effectRows[i].effect != 1u << i)
            return false;
    return true;
}());

std::span<const EffectRow> effectTable() {
    return effectRows;
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
