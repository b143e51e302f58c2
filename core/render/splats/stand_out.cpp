#include "core/render/splats/stand_out.h"

#include "core/base/ranked.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// A disc stands out as far as this part of its neighbours lie below it: one normal gone wrong tells nothing.
constexpr std::size_t tellingPart = 4;
/// And a block as far as this many of its discs do.
constexpr std::size_t tellingDiscs = 4;
constexpr std::size_t leastNeighbours = 4;
/// In radii: where the nearest surfel across a crease is looked for, and its neighbours.
constexpr float across = 2, beside = 1.5f;

/// How far a disc stands out where its surface bends as it does towards a neighbour: d^2 / 2 rho, for d what it reaches
/// in that direction.
float standOutOver(const Vec3f& way, const Vec3f& normal, const Vec3f& shape, float radius) {
    return std::abs(dot(way, normal)) * radius * radius / surfel::shapedSq(way, shape);
}

} // namespace

StandOut::StandOut(const tree::SurfelTree& model, float radiusOfSupport)
    : m_model(model), m_radius(radiusOfSupport), m_shape(surfel::shapeChannel(*model.layout())),
      m_labels(cells::LabelLayout::of(*model.layout())) {}

StandOut::Disc StandOut::discAt(const SurfelBlock& block, int slot) const {
    return {block.position(slot), block.normal(slot), surfel::shapeOf(block, slot, m_shape),
            m_labels ? m_labels->cellAt(block, slot) : 0};
}

/// The cell across a crease may be none of the block's.
void StandOut::gatherAround(const SurfelBlock& block) {
    m_around.clear();
    bool any = false;
    for (int cluster = 0; m_labels && cluster < block.clusterCount(); ++cluster)
        any |= m_labels->anyMeets(block, cluster);
    if (!any)
        return;
    const base::Box3f box = block.box().inflated((across + beside) * m_radius * block.maxSupport());
    m_model.forBlocksInSupport(
        box,
        [&](std::uint32_t, const SurfelBlock& each) {
            for (int slot = 0; slot < each.size(); ++slot)
                if (box.contains(each.position(slot)))
                    m_around.push_back(discAt(each, slot));
        },
        (across + beside) * m_radius);
}

std::optional<float> StandOut::overNeighbours(const Disc& disc, std::span<const Disc> among, float radius) {
    m_heights.clear();
    for (const Disc& each : among) {
        const Vec3f way = each.position - disc.position;
        const float apart = lengthSq(way);
        if (each.cell == disc.cell && apart > 0.25f * radius * radius && apart < beside * beside * radius * radius)
            m_heights.push_back(standOutOver(way, disc.normal, disc.shape, radius));
    }
    if (m_heights.size() < leastNeighbours)
        return std::nullopt;
    return std::min(base::ranked(m_heights, m_heights.size() / tellingPart, std::greater<>()), radius);
}

/// Of the nearest surfel of the cell across, as if its disc were as large.
std::optional<float> StandOut::ofAcross(const Disc& disc, std::uint32_t partner, float radius) {
    const Disc* nearest = nullptr;
    float nearestSq = across * across * radius * radius;
    for (const Disc& each : m_around)
        if (const float distanceSq = lengthSq(each.position - disc.position);
            each.cell == partner && distanceSq < nearestSq)
            nearest = &each, nearestSq = distanceSq;
    return nearest ? overNeighbours(*nearest, m_around, radius) : std::nullopt;
}

float StandOut::of(const SurfelBlock& block) {
    gatherAround(block);
    m_own.clear();
    for (int slot = 0; slot < block.size(); ++slot)
        m_own.push_back(discAt(block, slot));
    std::vector<float> discs;
    for (int slot = 0; slot < block.size(); ++slot) {
        const Disc& disc = m_own[static_cast<std::size_t>(slot)];
        const float radius = m_radius * block.support(slot);
        std::optional<float> found = overNeighbours(disc, m_own, radius);
        if (!m_around.empty())
            if (const cells::Label label = m_labels->at(block, slot); label.meeting != cells::Meeting::None)
                found = std::max(found, ofAcross(disc, label.partner, radius));
        if (found)
            discs.push_back(*found);
    }
    if (discs.size() < tellingDiscs)
        return 0;
    return base::ranked(discs, tellingDiscs - 1, std::greater<>());
}

} // namespace render
