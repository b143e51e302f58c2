#include "core/cells/crease_bands.h"

#include <algorithm>

namespace cells {

constexpr std::size_t fewestEnds = 6; ///< of links that cross: a shorter crease is none

BandPairs::BandPairs(std::size_t size, std::span<const Link> crossing, std::vector<FlatLink> flat,
                     std::span<const std::uint32_t> ends)
    : m_sides(size) {
    for (const auto& [a, b] : crossing)
        m_sides.relate(a, b, true);
    std::sort(flat.begin(), flat.end());
    for (const FlatLink& link : flat)
        m_sides.relate(link.a, link.b, false);
    std::map<std::uint32_t, std::size_t> sizes;
    for (const std::uint32_t a : ends)
        ++sizes[m_sides.find(a).root];
    for (const auto& [root, count] : sizes)
        if (count >= fewestEnds)
            m_numbers.emplace(root, static_cast<std::uint32_t>(m_numbers.size()));
}

std::optional<std::uint32_t> BandPairs::bandOf(std::uint32_t end) {
    const auto [root, opposite] = m_sides.find(end);
    const auto at = m_numbers.find(root);
    if (at == m_numbers.end())
        return std::nullopt;
    return 2 * at->second + (opposite ? 1 : 0);
}

} // namespace cells
