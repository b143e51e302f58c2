#include "core/render/splats/label_cuts.h"

#include <algorithm>
#include <limits>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Of a crease: with less both sides are nearly one, and discs blend.
constexpr int leastSharpness = 128;
/// Surfels of a patch this much farther off than its nearest one, in radii of the smaller disc, tell of its plane
/// there.
constexpr float aboutNearest = 1;
/// Patches farther off than this, in radii, of the disc or of theirs, do not cut.
constexpr float reach = 2.5f;
/// Cosine between normals of a patch that is no plane to a disc that it cuts.
constexpr float turned = 0.9f;
/// A cut is rounded to 32nds of a radius: by half of one it leaves no crack.
constexpr float slack = 0.5f / 32;

} // namespace

void LabelCuts::gather(const SurfelBlock& block) {
    m_near.clear();
    const base::Box3f box = block.box().inflated((reach + aboutNearest) * m_radius * block.maxSupport());
    m_model.forBlocksInSupport(
        box,
        [&](std::uint32_t, const SurfelBlock& each) {
            for (int slot = 0; slot < each.size(); ++slot) {
                const cells::Label label = m_labels.at(each, slot);
                if (label.meeting == cells::Meeting::None)
                    continue;
                const float radius = m_radius * each.support(slot);
                if (box.inflated(reach * radius).contains(each.position(slot)))
                    m_near.push_back({each.position(slot), each.normal(slot), radius, label});
            }
        },
        reach * m_radius);
}

std::optional<LabelCuts::Edge> LabelCuts::edgeTo(std::uint32_t cell, cells::Meeting meeting, const Disc& disc) const {
    float nearestSq = std::numeric_limits<float>::infinity();
    float radius = 0;
    for (const Disc& each : m_near) {
        const float distanceSq = lengthSq(each.centre - disc.centre), most = reach * std::max(disc.radius, each.radius);
        if (each.label.cell == cell && distanceSq < std::min(nearestSq, most * most)) {
            nearestSq = distanceSq;
            radius = std::min(disc.radius, each.radius);
        }
    }
    if (!(radius > 0))
        return std::nullopt;
    const float far = std::sqrt(nearestSq) + aboutNearest * radius;
    Vec3f normal, way;
    float total = 0;
    for (const Disc& each : m_near) {
        const float part = lengthSq(each.centre - disc.centre) / (far * far);
        if (each.label.cell != cell || !(part < 1))
            continue;
        const float weight = (1 - part) * (1 - part);
        normal += each.normal * weight, way += (each.centre - disc.centre) * weight, total += weight;
    }
    normal = normalized(normal, Vec3f{}), way = way / std::max(total, 1e-30f);
    const Vec3f own = normal;
    if (meeting == cells::Meeting::Concave)
        normal = -normal; // what is kept is in front of the patch
    const Vec3f across = normal - disc.normal * dot(normal, disc.normal);
    const float sine = length(across);
    if (!(sine > 0.05f))
        return std::nullopt;
    return Edge{across / sine, dot(way, normal) / sine, own, way};
}

/// Do the patches across two creases of a disc's own meet the other way than it meets them? Then it goes on behind
/// either.
bool LabelCuts::reflex(const Edge& a, const Edge& b, cells::Meeting meeting) {
    const bool convex = dot(a.normal - b.normal, b.way - a.way) < 0;
    return convex != (meeting == cells::Meeting::Convex);
}

/// Does no line cut the disc, as there is another crease of its patch, or the patch across turns below it?
bool LabelCuts::isCornerBy(const Disc& each, const Edge& edge, const Disc& disc) const {
    const float distanceSq = lengthSq(each.centre - disc.centre), radiusSq = disc.radius * disc.radius;
    if (each.label.cell == disc.label.partner && dot(each.normal, edge.normal) < turned && distanceSq < radiusSq)
        return true;
    if (each.label.cell != disc.label.cell || each.label.partner == disc.label.partner || distanceSq > 4 * radiusSq)
        return false;
    const auto other = edgeTo(each.label.partner, each.label.meeting, disc);
    return other && other->distance < cutRadius * disc.radius &&
           !(each.label.meeting == disc.label.meeting && reflex(edge, *other, disc.label.meeting));
}

CutCode LabelCuts::cutOf(const Disc& disc) const {
    const auto edge = edgeTo(disc.label.partner, disc.label.meeting, disc);
    if (!edge)
        return wholeDisc;
    const bool corner =
        std::any_of(m_near.begin(), m_near.end(), [&](const Disc& each) { return isCornerBy(each, *edge, disc); });
    return cutCode(disc.normal, edge->direction, edge->distance / disc.radius + slack, corner);
}

bool LabelCuts::cut(const SurfelBlock& block, CutCodes& codes) {
    bool gathered = false, any = false;
    for (int slot = 0; slot < block.size(); ++slot) {
        CutCode& code = codes[static_cast<std::size_t>(slot)];
        const Disc disc{block.position(slot), block.normal(slot), m_radius * block.support(slot),
                        m_labels.at(block, slot)};
        if (code != wholeDisc || disc.label.meeting == cells::Meeting::None || disc.label.sharpness < leastSharpness ||
            lengthSq(disc.normal) < 0.25f)
            continue;
        if (!gathered)
            gather(block);
        gathered = true;
        code = cutOf(disc);
        any |= code != wholeDisc;
    }
    return any;
}

} // namespace render
