// Parts of space, and the surfels in them: a region tells of a box whether it lies inside, outside or partly in it, and
// of a point whether it holds it, so that whole branches of the tree are taken or left without a look at their surfels.
//
// Coordinates are stored ones, float64. Regions are plain values; a new one is a struct with `relation` and `holds`.
// REQUIRES of every region: where relation(box) is Inside or Outside, holds(x) says the same for each x of the box.
#pragma once

#include "core/base/parallel.h"
#include "core/base/plane.h"
#include "core/selection/field.h"

namespace selection {

enum class Relation { Outside, Partly, Inside };

struct BallRegion {
    base::Vec3d centre;
    double radius = 0;

    bool holds(const base::Vec3d& x) const { return distanceSq(x, centre) <= radius * radius; }
    Relation relation(const base::Box3d& box) const;
};

struct BoxRegion {
    base::Box3d box;

    bool holds(const base::Vec3d& x) const { return box.contains(x); }
    Relation relation(const base::Box3d& other) const;
};

/// The half of space that the plane keeps.
struct PlaneRegion {
    base::Plane plane;

    bool holds(const base::Vec3d& x) const { return plane.distance(x) >= 0; }
    Relation relation(const base::Box3d& box) const;
};

namespace detail {

struct RegionVisit {
    std::uint32_t number;
    const surfel::SurfelBlock* block;
    bool inside; ///< all of it
};

template <class Region>
void visitRegion(const tree::Node& node, std::uint32_t first, const Region& region, bool inside,
                 std::vector<RegionVisit>& out) {
    for (int i = 0; i < node.childCount; ++i) {
        Relation relation = Relation::Inside;
        if (!inside) {
            const base::Box3f box = node.box(i);
            relation = region.relation({base::cast<double>(box.lo), base::cast<double>(box.hi)});
        }
        if (relation == Relation::Outside)
            continue;
        const std::uint32_t number = first + node.firstBlock[i];
        const auto at = static_cast<std::size_t>(i);
        if (node.level == 1)
            out.push_back({number, node.blocks[at].get(), relation == Relation::Inside});
        else
            visitRegion(*node.nodes[at], number, region, relation == Relation::Inside, out);
    }
}

} // namespace detail

/// The surfels that a region holds. Cost: the blocks inside and those that its border passes.
template <class Region>
tree::Selection within(const tree::SurfelTree& tree, const Region& region) {
    std::vector<detail::RegionVisit> visits;
    if (tree.root())
        detail::visitRegion(*tree.root(), 0, region, false, visits);
    tree::Selection out(visits.size());
    base::parallelFor(visits.size(), 16, [&](std::size_t i) {
        const auto& [number, block, inside] = visits[i];
        out[i].block = number;
        for (int slot = 0; slot < block->size(); ++slot)
            out[i].slots[static_cast<std::size_t>(slot)] =
                inside || region.holds(base::cast<double>(block->position(slot)));
    });
    std::erase_if(out, [](const tree::SelectedBlock& block) { return block.slots.none(); });
    return out;
}

} // namespace selection
