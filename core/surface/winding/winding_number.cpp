#include "core/surface/winding/winding_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace surface {

using base::Vec3d, base::Vec3f;

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

struct Part {
    Sum sum;
    base::Box3f box;
};

class Grouping {
  public:
    Grouping(double scale, std::vector<WindingGroup>& groups) : m_scale(scale), m_groups(groups) {}

    Sum addNode(const tree::Node& node, const base::Box3f& box, const float*& areas) {
        return addParts(box, node.childCount, [&](int child) {
            const auto at = static_cast<std::size_t>(child);
            return Part{node.level == 1 ? addBlock(*node.blocks[at], areas)
                                        : addNode(*node.nodes[at], node.box(child), areas),
                        node.box(child)};
        });
    }
    Part addRun(std::span<const Vec3f> places, std::span<const Vec3f> areas) {
        base::Box3f box;
        for (const Vec3f& each : places)
            box.extend(each);
        if (places.size() <= surfel::clusterSize)
            return {addCluster(box, places, areas), box};
        std::size_t run = surfel::clusterSize;
        while (run * WindingGroup::lanes < places.size())
            run *= WindingGroup::lanes;
        return {addParts(box, static_cast<int>((places.size() + run - 1) / run),
                         [&](int k) {
                             const std::size_t from = static_cast<std::size_t>(k) * run;
                             const std::size_t count = std::min(run, places.size() - from);
                             return addRun(places.subspan(from, count), areas.subspan(from, count));
                         }),
                box};
    }

  private:
    Sum addBlock(const surfel::SurfelBlock& block, const float*& areas) {
        return addParts(block.box(), block.clusterCount(), [&](int cluster) {
            const int first = cluster * surfel::clusterSize, end = std::min(block.size(), first + surfel::clusterSize);
            std::array<Vec3f, surfel::clusterSize> places, each;
            std::size_t count = 0;
            for (int slot = first; slot < end; ++slot, ++count) {
                places[count] = block.position(slot);
                each[count] = block.normal(slot) * *areas++;
            }
            const base::Box3f box = block.bounds(cluster).box;
            return Part{addCluster(box, std::span(places).first(count), std::span(each).first(count)), box};
        });
    }

    /// A group of what `add` adds after it, one a lane.
    template <class Add>
    Sum addParts(const base::Box3f& box, int count, const Add& add) {
        const std::uint32_t group = begin(box);
        Sum sum;
        for (int lane = 0; lane < count; ++lane) {
            const auto below = static_cast<std::uint32_t>(m_groups.size());
            const Part part = add(lane);
            setPart(group, static_cast<std::size_t>(lane), part, below);
            sum.add(part.sum);
        }
        return sum;
    }

    Sum addCluster(const base::Box3f& box, std::span<const Vec3f> places, std::span<const Vec3f> areas) {
        Sum sum;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::size_t lane = i % WindingGroup::lanes;
            if (lane == 0) {
                const std::uint32_t group = begin(box);
                if (i > 0)
                    m_groups[group - 1].next = group;
            }
            const Vec3d place = base::cast<double>(places[i]) * m_scale;
            const Vec3d area = base::cast<double>(areas[i]) * (m_scale * m_scale);
            set(m_groups.back(), lane, place, area);
            m_groups.back().softSq[lane] = static_cast<float>(soft * length(area));
            sum.add({area, place * length(area), length(area)});
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

    void setPart(std::uint32_t number, std::size_t lane, const Part& part, std::uint32_t below) {
        WindingGroup& group = m_groups[number];
        const Vec3d lo = base::cast<double>(part.box.lo) * m_scale, hi = base::cast<double>(part.box.hi) * m_scale;
        const Vec3d place = part.sum.weight > 0 ? part.sum.moment / part.sum.weight : (lo + hi) / 2;
        const Vec3d corner{std::max(place.x - lo.x, hi.x - place.x), std::max(place.y - lo.y, hi.y - place.y),
                           std::max(place.z - lo.z, hi.z - place.z)};
        set(group, lane, place, part.sum.area);
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

    double m_scale;
    std::vector<WindingGroup>& m_groups;
};

} // namespace

WindingNumber::WindingNumber(const tree::SurfelTree& tree, const base::Progress& progress, Areas which) {
    if (!tree.root())
        return;
    chooseScale(tree.bounds());
    const std::vector<float> areas = surfelAreas(tree, progress, which);
    m_groups.reserve(areas.size() / 6);
    const float* next = areas.data();
    Grouping(m_scale, m_groups).addNode(*tree.root(), tree.bounds(), next);
}

WindingNumber::WindingNumber(std::span<const Vec3f> places, std::span<const Vec3f> areas) {
    base::Box3f box;
    for (const Vec3f& each : places)
        box.extend(each);
    chooseScale(box);
    Grouping(m_scale, m_groups).addRun(places, areas);
}

/// A power of two: no place is rounded.
void WindingNumber::chooseScale(const base::Box3f& box) {
    const Vec3f size = box.size();
    if (const float largest = std::max({size.x, size.y, size.z}); largest > 0)
        m_scale = std::ldexp(1.0, -std::ilogb(largest));
}

double WindingNumber::at(const Vec3d& x) const {
    return windingKernel(m_groups, x * m_scale) / fourPi;
}

Vec3d WindingNumber::gradient(const Vec3d& x) const {
    return windingGradientKernel(m_groups, x * m_scale) * (m_scale / fourPi);
}

} // namespace surface
