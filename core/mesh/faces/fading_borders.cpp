#include "core/mesh/faces/fading_borders.h"

#include "core/surface/evaluation/weights.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;

constexpr double reachOfSupport = 0.8; ///< of links whose share tells how sharp the crease is
constexpr double leastShare = 0.15, shareRange = 0.6;

FadingBorders::FadingBorders(const std::vector<BorderLink>& links, double support) : m_reach(reachOfSupport * support) {
    for (const BorderLink& link : links)
        m_links.at(base::cellOf(link.middle, Vec3d(), 1 / m_reach)).push_back(link);
}

std::uint8_t FadingBorders::sharpness(std::uint32_t a, std::uint32_t b, const Vec3d& place) const {
    const auto cells = std::minmax(a, b);
    double cut = 0, all = 0;
    base::forCellsAround(base::cellOf(place, Vec3d(), 1 / m_reach), [&](const base::Cell& around) {
        if (const std::vector<BorderLink>* there = m_links.find(around))
            for (const BorderLink& each : *there) {
                const double distance = base::distance(each.middle, place);
                if (each.cells.first != cells.first || each.cells.second != cells.second || !(distance < m_reach))
                    continue;
                const auto weight = static_cast<double>(surface::wendlandC2(static_cast<float>(distance / m_reach)));
                all += weight;
                cut += each.cut ? weight : 0;
            }
    });
    const double share = all > 0 ? cut / all : 0;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp((share - leastShare) / shareRange, 0.0, 1.0)));
}

} // namespace mesh
