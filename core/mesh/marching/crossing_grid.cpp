#include "core/mesh/marching/crossing_grid.h"

#include "core/mesh/marching/solid_edge.h"

#include <algorithm>

namespace mesh {

using base::Vec3d, base::Vec3f;
using surface::Evaluationf;

std::vector<surfel::BlockPtr> CrossingGrid::allBlocks() const {
    std::vector<surfel::BlockPtr> out;
    const tree::SurfelTree& tree = m_surface.tree();
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock&) { out.push_back(tree.block(number)); });
    return out;
}

std::vector<CrossingGrid::Disc> CrossingGrid::discsOf(std::span<const surfel::BlockPtr> blocks) const {
    constexpr double furthest = 0.5; // of h
    std::vector<Vec3f> x;
    for (const surfel::BlockPtr& block : blocks)
        for (int slot = 0; slot < block->size(); ++slot)
            x.push_back(block->position(slot));
    std::vector<Evaluationf> at(x.size());
    m_surface.evaluate(x, surface::Need::Value, at);
    std::vector<Disc> out;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double unit = double(at[i].unit);
        if (!NodeValue::of(at[i]).usable())
            continue;
        const Vec3d n = base::cast<double>(at[i].normal);
        const Vec3d foot =
            base::cast<double>(x[i]) - n * std::clamp(double(at[i].value), -furthest * unit, furthest * unit);
        out.push_back({foot, n, unit});
    }
    return out;
}

std::vector<CrossingGrid::NodeSide> CrossingGrid::evaluated(std::span<const Vec3f> x) const {
    std::vector<Evaluationf> at(x.size());
    std::vector<SolidSide> sides(x.size(), SolidSide::Untold);
    if (m_solid)
        sides = m_solid->sides(x, at);
    else
        m_surface.evaluate(x, surface::Need::Value, at);
    std::vector<NodeSide> out;
    out.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        out.push_back({NodeValue::of(at[i]), sides[i]});
    return out;
}

bool CrossingGrid::mayCross(const Edge& edge, const NodeSide& first, const NodeSide& last) const {
    if (told(first.side) && told(last.side))
        return first.side != last.side;
    return !EdgeWalk::passes(m_traits, edge, first.value, last.value);
}

std::optional<Crossing> CrossingGrid::crossingOn(const Edge& edge, const NodeSide& first, const NodeSide& last,
                                                 surface::Source& source, Care care) const {
    if (told(first.side) && told(last.side)) {
        if (first.side == last.side)
            return std::nullopt;
        return solidCrossing(*m_solid, m_traits, source, edge,
                             {first.value, last.value, first.side == SolidSide::Inside ? 1 : -1});
    }
    return EdgeWalk(m_traits, source, edge, care).run(first.value, last.value);
}

} // namespace mesh
