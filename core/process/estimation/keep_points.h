// Takes points out of a list, with what they carry.
#pragma once

#include "core/surfel/surfel.h"

#include <algorithm>

namespace process {

/// Keeps those for which `keep(i)` is true, in their order.
template <class Keep>
void keepPoints(surfel::SurfelList& points, const Keep& keep) {
    const std::size_t words = points.layout->words();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!keep(i))
            continue;
        points.items[kept] = points.items[i];
        std::copy_n(points.extra.begin() + static_cast<std::ptrdiff_t>(i * words), words,
                    points.extra.begin() + static_cast<std::ptrdiff_t>(kept * words));
        ++kept;
    }
    points.items.resize(kept);
    points.extra.resize(kept * words);
}

} // namespace process
