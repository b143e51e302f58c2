#include "core/mesh/faces/near_spacings.h"

#include "core/base/cancel_scope.h"

#include <algorithm>
#include <cmath>

namespace mesh {

using base::Vec3d;

constexpr std::uint32_t leafSize = 8;

NearSpacings::NearSpacings(std::vector<SpacedPlace> places, double slope)
    : m_places(std::move(places)), m_slope(slope) {
    if (!m_places.empty())
        build(0, static_cast<std::uint32_t>(m_places.size()));
}

std::uint32_t NearSpacings::build(std::uint32_t begin, std::uint32_t end) {
    base::CancelScope::check();
    const auto self = static_cast<std::uint32_t>(m_nodes.size());
    Node node{{}, m_places[begin].spacing, foot(m_places[begin]), begin, end};
    for (std::uint32_t i = begin; i < end; ++i) {
        node.box.extend(m_places[i].place);
        node.least = std::min(node.least, m_places[i].spacing);
        node.foot = std::min(node.foot, foot(m_places[i]));
    }
    m_nodes.push_back(node);
    if (end - begin <= leafSize)
        return self;
    const Vec3d size = node.box.size();
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) { return m_places.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end),
                     [axis](const SpacedPlace& a, const SpacedPlace& b) { return a.place[axis] < b.place[axis]; });
    build(begin, middle);
    const std::uint32_t second = build(middle, end);
    m_nodes[self].second = second;
    return self;
}

double NearSpacings::allowed(double spacing, double foot, double distanceSq) const {
    return std::max(spacing, foot + m_slope * std::sqrt(distanceSq));
}

void NearSpacings::search(std::uint32_t index, const Vec3d& p, double& most) const {
    const Node& node = m_nodes[index];
    if (node.second == 0) {
        for (std::uint32_t i = node.begin; i < node.end; ++i)
            most = std::min(most, allowed(m_places[i].spacing, foot(m_places[i]), distanceSq(m_places[i].place, p)));
        return;
    }
    const auto bound = [&](std::uint32_t child) {
        return allowed(m_nodes[child].least, m_nodes[child].foot, m_nodes[child].box.distanceSq(p));
    };
    std::uint32_t children[2] = {index + 1, node.second};
    double bounds[2] = {bound(children[0]), bound(children[1])};
    if (bounds[1] < bounds[0])
        std::swap(children[0], children[1]), std::swap(bounds[0], bounds[1]);
    for (std::size_t k = 0; k < 2; ++k)
        if (bounds[k] < most)
            search(children[k], p, most);
}

double NearSpacings::at(const Vec3d& p, double most) const {
    if (!m_nodes.empty() && m_nodes.front().least < most)
        search(0, p, most);
    return most;
}

} // namespace mesh
