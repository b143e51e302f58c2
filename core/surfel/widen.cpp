#include "core/surfel/widen.h"

#include <algorithm>

namespace surfel {

void widen(SurfelList& list, AttributeLayoutPtr layout) {
    const std::size_t before = list.layout->words(), words = layout->words();
    if (words > before) {
        std::vector<std::uint32_t> extra(words * list.size());
        for (std::size_t i = 0; i < list.size(); ++i)
            std::copy_n(list.extra.begin() + static_cast<std::ptrdiff_t>(i * before), before,
                        extra.begin() + static_cast<std::ptrdiff_t>(i * words));
        list.extra = std::move(extra);
    }
    list.layout = std::move(layout);
}

} // namespace surfel
