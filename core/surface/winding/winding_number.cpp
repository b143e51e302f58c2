#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surface {

using base::Vec3d;

namespace {

constexpr double fourPi = 4 * std::numbers::pi;
/// Distance over a group's radius from which it is one dipole: w is then within 0.03 of the whole sum.
constexpr double farAway = 3;
constexpr double soft = 0.25; ///< of the area: half a spacing, squared

/// Dipoles as one.
struct Sum {
    Vec3d area, moment;
    double weight = 0;

    void add(const Sum& more) {
        area += more.area;
        moment += more.moment;
        weight += more.weight;
    }
};

class Grouping {
  public:
    Grouping(std::span<const float> areas, double scale, std::vector<WindingGroup>& groups)
        : m_areas(areas), m_scale(scale), m_groups(groups) {}

    Sum addNode(const tree::Node& node, const base::Box3f& box) {
        const std::uint32_t group = begin(box);
        Sum sum;
        for (int child = 0; child < node.childCount; ++child) {
            const auto at = static_cast<std::size_t>(child);
            const auto below = static_cast<std::uint32_t>(m_groups.size());
            const Sum part = node.level == 1 ? addBlock(*node.blocks[at]) : addNode(*node.nodes[at], node.box(child));
            setPart(group, at, part, node.box(child), below);
            sum.add(part);
        }
        return sum;
    }

  private:
    Sum addBlock(const surfel::SurfelBlock& block) {
        const std::uint32_t group = begin(block.box());
        Sum sum;
        for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
            const auto below = static_cast<std::uint32_t>(m_groups.size());
            const Sum part = addCluster(block, cluster);
            setPart(group, static_cast<std::size_t>(cluster), part, block.bounds(cluster).box, below);
            sum.add(part);
        }
        return sum;
    }

    Sum addCluster(const surfel::SurfelBlock& block, int cluster) {
        constexpr int lanes = static_cast<int>(WindingGroup::lanes);
        const int first = cluster * surfel::clusterSize, end = std::min(block.size(), first + surfel::clusterSize);
        Sum sum;
        for (int slot = first; slot < end; ++slot) {
            const int lane = (slot - first) % lanes;
            if (lane == 0) {
                const std::uint32_t group = begin(block.bounds(cluster).box);
                if (slot > first)
                    m_groups[group - 1].next = group;
            }
            const double area = static_cast<double>(m_areas[m_next++]) * m_scale * m_scale;
            const Vec3d place = base::cast<double>(block.position(slot)) * m_scale;
            const Vec3d each = base::cast<double>(block.normal(slot)) * area;
            set(m_groups.back(), static_cast<std::size_t>(lane), place, each);
            m_groups.back().softSq[lane] = static_cast<float>(soft * area);
            sum.add({each, place * length(each), length(each)});
        }
        return sum;
    }

    /// A group in which no lane counts yet.
    std::uint32_t begin(const base::Box3f& box) {
        WindingGroup& group = m_groups.emplace_back();
        std::ranges::fill(group.softSq, 1.0f);
        std::ranges::fill(group.farSq, -1.0f);
        group.centre = base::cast<float>(base::cast<double>(box.centre()) * m_scale);
        return static_cast<std::uint32_t>(m_groups.size() - 1);
    }

    void setPart(std::uint32_t number, std::size_t lane, const Sum& part, const base::Box3f& box, std::uint32_t below) {
        WindingGroup& group = m_groups[number];
        const Vec3d lo = base::cast<double>(box.lo) * m_scale, hi = base::cast<double>(box.hi) * m_scale;
        const Vec3d place = part.weight > 0 ? part.moment / part.weight : (lo + hi) / 2;
        const Vec3d corner{std::max(place.x - lo.x, hi.x - place.x), std::max(place.y - lo.y, hi.y - place.y),
                           std::max(place.z - lo.z, hi.z - place.z)};
        set(group, lane, place, part.area);
        group.softSq[lane] = 0;
        group.farSq[lane] = static_cast<float>(farAway * farAway * lengthSq(corner));
        group.below[lane] = below;
    }

    static void set(WindingGroup& group, std::size_t lane, const Vec3d& place, const Vec3d& area) {
        const Vec3d from = place - base::cast<double>(group.centre);
        group.x[lane] = static_cast<float>(from.x);
        group.y[lane] = static_cast<float>(from.y);
        group.z[lane] = static_cast<float>(from.z);
        group.areaX[lane] = static_cast<float>(area.x);
        group.areaY[lane] = static_cast<float>(area.y);
        group.areaZ[lane] = static_cast<float>(area.z);
    }

    std::span<const float> m_areas; ///< in tree order
    std::size_t m_next = 0;         ///< of them
    double m_scale;
    std::vector<WindingGroup>& m_groups;
};

} // namespace

WindingNumber::WindingNumber(const tree::SurfelTree& tree, const base::Progress& progress, Areas which) {
    if (!tree.root())
        return;
    const base::Vec3f size = tree.bounds().size();
    if (const float largest = std::max({size.x, size.y, size.z}); largest > 0)
        m_scale = std::ldexp(1.0, -std::ilogb(largest)); // a power of two: no place is rounded
    const std::vector<float> areas = surfelAreas(tree, progress, which);
    m_groups.reserve(areas.size() / 6);
    Grouping(areas, m_scale, m_groups).addNode(*tree.root(), tree.bounds());
}

double WindingNumber::at(const Vec3d& x) const {
    return windingKernel(m_groups, x * m_scale) / fourPi;
}

Vec3d WindingNumber::gradient(const Vec3d& x) const {
    return windingGradientKernel(m_groups, x * m_scale) * (m_scale / fourPi);
}

} // namespace surface
