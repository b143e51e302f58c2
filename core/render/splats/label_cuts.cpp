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
/// What is left of a disc at a corner may reach over the second edge by this part of the radius: smaller ones leave
/// gaps. Edges that meet at an angle near 180 degrees (cosine between their directions) are one.
constexpr float mostOver = 0.2f, nearlyOne = 0.5f;
/// A cut is rounded to 32nds of a radius: by half of one it leaves no crack.
constexpr float slack = 0.5f / 32;

} // namespace

void LabelCuts::gather(const SurfelBlock& block) {
    m_near.clear();
    const float own = m_radius * block.maxSupport(); // partners may be sampled more finely
    const base::Box3f box = block.box().inflated((reach + aboutNearest) * own);
    m_model.forBlocksInSupport(
        box,
        [&](std::uint32_t, const SurfelBlock& each) {
            for (int slot = 0; slot < each.size(); ++slot) {
                const cells::Label label = m_labels.at(each, slot);
                if (label.meeting == cells::Meeting::None)
                    continue;
                const float radius = m_radius * each.support(slot);
                if (box.inflated(reach * std::max(radius, own)).contains(each.position(slot)))
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
    return Edge{across / sine, dot(way, normal) / sine, own, way, cell};
}

/// Do the patches across two creases of a disc's own meet the other way than it meets them? Then it goes on behind
/// either.
bool LabelCuts::reflex(const Edge& a, const Edge& b, cells::Meeting meeting) {
    const bool convex = dot(a.normal - b.normal, b.way - a.way) < 0;
    return convex != (meeting == cells::Meeting::Convex);
}

/// Does the patch across turn below the disc, so that no line cuts it?
bool LabelCuts::turnsAway(const Edge& edge, const Disc& disc) const {
    return std::any_of(m_near.begin(), m_near.end(), [&](const Disc& each) {
        return each.label.cell == edge.cell && dot(each.normal, edge.normal) < turned &&
               lengthSq(each.centre - disc.centre) < disc.radius * disc.radius;
    });
}

/// Lines at which the disc's patch ends within it: that of its partner first, which may be farther off.
std::vector<LabelCuts::Edge> LabelCuts::edgesOf(const Disc& disc) const {
    std::vector<Edge> out;
    if (const auto edge = edgeTo(disc.label.partner, disc.label.meeting, disc))
        out.push_back(*edge);
    for (const Disc& each : m_near) {
        const cells::Label& label = each.label;
        if (label.cell != disc.label.cell || label.partner == disc.label.partner ||
            lengthSq(each.centre - disc.centre) > 4 * disc.radius * disc.radius ||
            std::any_of(out.begin(), out.end(), [&](const Edge& known) { return known.cell == label.partner; }))
            continue;
        const auto other = edgeTo(label.partner, label.meeting, disc);
        if (other && other->distance < cutRadius * disc.radius &&
            !(!out.empty() && label.meeting == disc.label.meeting && reflex(out.front(), *other, label.meeting)))
            out.push_back(*other);
    }
    return out;
}

namespace {

/// How far what is left of a disc, by a line at `distance` and the radius, goes in a direction with that cosine to the
/// line's.
float reachOf(float distance, float radius, float cosine) {
    if (cosine * radius <= distance)
        return radius;
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return cosine * distance + sine * std::sqrt(std::max(0.0f, radius * radius - distance * distance));
}

} // namespace

CutCode LabelCuts::cutOf(const Disc& disc) const {
    const std::vector<Edge> edges = edgesOf(disc);
    if (edges.empty())
        return wholeDisc;
    const auto code = [&](const Edge& by, Beside beside) {
        return cutCode(disc.normal, by.direction, by.distance / disc.radius + slack, beside);
    };
    const Edge& first = edges.front();
    for (const Edge& other : std::span(edges).subspan(1)) {
        const float cosine = dot(first.direction, other.direction), radius = cornerRadius * disc.radius;
        const float over = reachOf(first.distance, radius, cosine) - other.distance;
        const float overFirst = reachOf(other.distance, radius, cosine) - first.distance;
        if (cosine > nearlyOne || over < mostOver * disc.radius)
            continue;
        if (overFirst < mostOver * disc.radius && edges.size() == 2)
            return code(other, Beside::Corner);
        return code(other.distance < first.distance ? other : first, Beside::Tip);
    }
    return code(first, edges.size() > 1 || turnsAway(first, disc) ? Beside::Corner : Beside::Edge);
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
