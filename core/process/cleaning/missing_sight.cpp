#include "core/process/cleaning/missing_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace process {

std::vector<float> missingSight(const Cloud& part, const float (&low)[2], const float (&high)[2],
                                const base::Progress& progress) {
    // The way that looks farthest asks for 30 neighbours; each is compared with neighbours and what these see.
    constexpr std::size_t farthest = 30, handed = 16, hands = 2;
    std::vector<float> lacking(part.size());
    if (std::isinf(low[0]) && std::isinf(low[1]) && std::isinf(high[0]) && std::isinf(high[1])) // the whole
        return lacking;
    if (part.size() <= farthest) { // about as much again
        float out = std::numeric_limits<float>::min();
        for (const float side : {low[0], low[1], high[0], high[1]})
            out = std::isfinite(side) ? std::max(out, std::abs(side)) : out;
        std::fill(lacking.begin(), lacking.end(), out);
        return lacking;
    }
    std::vector<std::uint32_t> near(part.size() * handed);
    part.forEach(farthest, progress, "Looking at neighbours", [&](std::size_t i, const Neighbours& row) {
        const base::Vec3f& p = part.positions()[i];
        const float room = std::min({p.x - low[0], high[0] - p.x, p.y - low[1], high[1] - p.y});
        lacking[i] = std::max(0.0f, std::sqrt(row.distanceSq.back()) - room);
        std::copy_n(row.index.begin(), handed, near.begin() + static_cast<std::ptrdiff_t>(i * handed));
    });
    for (std::size_t hand = 0; hand < hands; ++hand) {
        std::vector<float> next = lacking;
        for (std::size_t i = 0; i < next.size(); ++i)
            for (std::size_t k = 0; k < handed; ++k)
                next[i] = std::max(next[i], lacking[near[i * handed + k]]);
        lacking = std::move(next);
    }
    return lacking;
}

} // namespace process
