#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surface {

using base::Vec3d, base::Vec3f;

namespace {

constexpr double fourPi = 4 * std::numbers::pi;
/// Distance over a group's radius from which it is one dipole: w is then within 0.03 of the whole sum.
constexpr float farAway = 3;
constexpr float soft = 0.25f; ///< of the area: half a spacing, squared

} // namespace

WindingNumber::WindingNumber(const tree::SurfelTree& tree, const base::Progress& progress, Areas which)
    : m_areas(surfelAreas(tree, progress, which)) {
    m_dipoles.reserve(tree.size());
    if (tree.root())
        addNode(*tree.root(), tree.bounds());
    m_areas = {};
}

/// Its own cell, those of what is below, then the sums over them.
void WindingNumber::addNode(const tree::Node& node, const base::Box3f& box) {
    const std::size_t cell = m_cells.size(), first = m_dipoles.size();
    m_cells.emplace_back();
    for (int child = 0; child < node.childCount; ++child)
        if (node.level == 1)
            addBlock(*node.blocks[static_cast<std::size_t>(child)]);
        else
            addNode(*node.nodes[static_cast<std::size_t>(child)], node.box(child));
    finish(cell, first, box);
}

void WindingNumber::addBlock(const surfel::SurfelBlock& block) {
    const std::size_t cell = m_cells.size(), first = m_dipoles.size();
    m_cells.emplace_back();
    for (int begin = 0; begin < block.size(); begin += surfel::clusterSize) {
        const std::size_t leaf = m_cells.size(), from = m_dipoles.size();
        m_cells.emplace_back();
        const int end = std::min(block.size(), begin + surfel::clusterSize);
        for (int slot = begin; slot < end; ++slot) {
            const float area = m_areas[m_dipoles.size()];
            m_dipoles.push_back({block.position(slot), block.normal(slot) * area, soft * area});
        }
        m_cells[leaf].first = static_cast<std::uint32_t>(from);
        m_cells[leaf].count = static_cast<std::uint32_t>(m_dipoles.size() - from);
        finish(leaf, from, block.bounds(begin / surfel::clusterSize).box);
    }
    finish(cell, first, block.box());
}

void WindingNumber::finish(std::size_t cell, std::size_t firstDipole, const base::Box3f& box) {
    const Vec3f middle = (box.lo + box.hi) * 0.5f;
    Vec3d area, place;
    double sum = 0;
    for (std::size_t i = firstDipole; i < m_dipoles.size(); ++i) {
        const Vec3d each = base::cast<double>(m_dipoles[i].area);
        const double size = length(each);
        area += each;
        place += base::cast<double>(m_dipoles[i].place - middle) * size;
        sum += size;
    }
    Cell& out = m_cells[cell];
    out.whole.area = base::cast<float>(area);
    out.whole.place = middle + (sum > 0 ? base::cast<float>(place / sum) : Vec3f{});
    const Vec3f below = out.whole.place - box.lo, above = box.hi - out.whole.place;
    const Vec3f corner{std::max(below.x, above.x), std::max(below.y, above.y), std::max(below.z, above.z)};
    out.farSq = farAway * farAway * lengthSq(corner);
    out.next = static_cast<std::uint32_t>(m_cells.size());
}

/// fn(dipole, offset from x).
template <class Fn>
void WindingNumber::forTerms(const Vec3d& x, const Fn& fn) const {
    for (std::size_t at = 0; at < m_cells.size();) {
        const Cell& cell = m_cells[at];
        const Vec3d to = base::cast<double>(cell.whole.place) - x;
        if (lengthSq(to) > double(cell.farSq)) {
            fn(cell.whole, to);
        } else if (cell.count == 0) {
            ++at;
            continue;
        } else {
            for (std::uint32_t i = cell.first; i < cell.first + cell.count; ++i)
                fn(m_dipoles[i], base::cast<double>(m_dipoles[i].place) - x);
        }
        at = cell.next;
    }
}

double WindingNumber::at(const Vec3d& x) const {
    double sum = 0;
    forTerms(x, [&](const Dipole& each, const Vec3d& to) {
        const double squared = lengthSq(to) + double(each.softSq);
        if (squared > 0)
            sum += dot(base::cast<double>(each.area), to) / (squared * std::sqrt(squared));
    });
    return sum / fourPi;
}

Vec3d WindingNumber::gradient(const Vec3d& x) const {
    Vec3d sum;
    forTerms(x, [&](const Dipole& each, const Vec3d& to) {
        const Vec3d area = base::cast<double>(each.area);
        const double squared = lengthSq(to) + double(each.softSq);
        if (squared > 0)
            sum += (to * (3 * dot(area, to) / squared) - area) / (squared * std::sqrt(squared));
    });
    return sum / fourPi;
}

} // namespace surface
