#include "core/render/splats/disc_cuts.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/self.h"

#include <algorithm>
#include <numbers>
#include <unordered_set>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;

namespace {

/// Off-centre values up to this part of the limit are no sign of a boundary within a disc's reach.
constexpr float quiet = 0.12f;
/// A surfel's normal this far (cosine) from that of the surface about it stands across.
constexpr float acrossCosine = 0.5f;
/// A surfel beyond the limit itself keeps this much of its disc towards the boundary.
constexpr float leastPart = 1 / 32.0f;

/// Neighbours and weights decide about off-centre values, not the frame or the limit.
surface::Surface plain(const tree::SurfelTree& model, surface::SurfaceDefinition definition) {
    definition.frame = surface::Frame::Normals;
    definition.oneSheet = false;
    definition.boundary = surface::Boundary::None;
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {model, definition};
}

/// The same as if normals had a common sign, which is fastest: it fails only where they cancel.
surface::Surface fastest(const surface::Surface& plain) {
    auto layout = std::make_shared<surfel::AttributeLayout>(*plain.tree().layout());
    layout->oriented = true;
    return {plain.tree().withLayout(layout), plain.definition()};
}

struct Around {
    float value = std::numeric_limits<float>::infinity(); ///< off-centre, in units of h
    Vec3f away;                                           ///< from the centroid
};

Around around(const surface::Surface& surface, const Vec3f& x) {
    const surface::Evaluationf e = surface.evaluate(x, surface::Need::Value);
    return e.ok() ? Around{e.offCentre / e.unit, x - e.centroid} : Around{};
}

Vec3f tangential(const Vec3f& v, const Vec3f& n) {
    return normalized(v - n * dot(n, v), Vec3f{});
}

/// The cut of a disc whose centre is off centre by `here` along the tangential direction `out`: the place along it
/// where the value reaches the limit, by regula falsi, and the direction of the boundary there.
CutCode cutOf(const surface::Surface& surface, const surfel::Surfel& s, const Vec3f& out, float radius, float here,
              float limit) {
    if (here >= limit)
        return cutCode(s.normal, out, leastPart);
    float low = 0, lowValue = here, high = 1;
    Around end = around(surface, s.position + out * radius);
    if (end.value <= limit)
        return wholeDisc;
    Vec3f direction = out;
    for (int step = 0; step < 5; ++step) {
        const float between = std::isfinite(end.value) ? (limit - lowValue) / (end.value - lowValue) : 0.5f;
        const float middle = low + (high - low) * std::clamp(between, 0.1f, 0.9f);
        const Around found = around(surface, s.position + out * (radius * middle));
        if (found.value <= limit)
            low = middle, lowValue = found.value;
        else
            high = middle, end = found;
        if (std::isfinite(found.value))
            direction = tangential(found.away, s.normal);
    }
    const float along = dot(direction, out);
    return along > 0.2f ? cutCode(s.normal, direction, 0.5f * (low + high) * along)
                        : cutCode(s.normal, out, 0.5f * (low + high));
}

/// A tangential direction that the angle of a code counts from.
Vec3f zeroAngle(const Vec3f& n, bool yAxis) {
    return normalized(yAxis ? Vec3f{n.z, 0, -n.x} : Vec3f{0, -n.z, n.y}, Vec3f{});
}

} // namespace

CutCode cutCode(const Vec3f& n, const Vec3f& direction, float part) {
    const long steps = std::max(1l, std::lround(part * 32));
    if (steps > 31)
        return wholeDisc;
    const bool yAxis = std::abs(n.x) > 0.8f;
    const Vec3f u = zeroAngle(n, yAxis), v = cross(n, u);
    const float turns = std::atan2(dot(direction, v), dot(direction, u)) / (2 * std::numbers::pi_v<float>);
    const auto angle = static_cast<unsigned>(std::lround(turns * 256)) & 255u;
    return static_cast<CutCode>((yAxis ? 1u << 13 : 0u) | angle << 5 | static_cast<unsigned>(steps));
}

DiscCut discCut(const Vec3f& n, CutCode code) {
    if ((code & 31u) == 0)
        return {};
    const Vec3f u = zeroAngle(n, (code >> 13 & 1u) != 0), v = cross(n, u);
    const float angle = static_cast<float>(code >> 5 & 255u) * (2 * std::numbers::pi_v<float> / 256);
    return {u * std::cos(angle) + v * std::sin(angle), static_cast<float>(code & 31u) / 32};
}

void DiscCuts::use(const surface::SurfaceDefinition& definition, float radiusOfSupport) {
    if (definition == m_definition && radiusOfSupport == m_radiusOfSupport)
        return;
    m_codes.clear();
    m_definition = definition;
    m_radiusOfSupport = radiusOfSupport;
}

DiscCuts::Found DiscCuts::look(std::span<const SurfelBlock* const> blocks) const {
    const bool oriented = m_model.layout()->oriented;
    const surface::Surface surface = plain(m_model, m_definition);
    const surface::Surface quick = oriented ? surface : fastest(surface);
    const float limit = m_definition.boundaryLimit;
    Found out(blocks.size());
    base::parallelChunks(blocks.size(), 4, [&](std::size_t begin, std::size_t end, std::size_t) {
        surface::SelfEvaluator self(quick);
        surface::SelfLanes at[surfel::clustersPerBlock];
        for (std::size_t b = begin; b < end; ++b) {
            const SurfelBlock& block = *blocks[b];
            self.evaluate(block, block.clusterMask(), surface::Need::Value, at);
            CutCodes codes{};
            bool any = false;
            for (int slot = 0; slot < block.size(); ++slot) {
                surface::SelfLanes& lanes = at[slot / surfel::clusterSize];
                const int lane = slot % surfel::clusterSize;
                if (lanes.status[lane] != surface::Status::Ok && !oriented) {
                    const surface::Evaluationf e = surface.evaluate(block.position(slot), surface::Need::Value);
                    lanes.set(lane, e);
                    lanes.status[lane] = e.status;
                }
                if (lanes.status[lane] != surface::Status::Ok)
                    continue;
                const Vec3f n = block.normal(slot);
                if (lengthSq(n) < 0.25f)
                    continue; // it has no plane
                const float facing = dot(n, lanes.normalAt(lane)), off = lanes.offCentre[lane] / lanes.unit[lane];
                CutCode& code = codes[static_cast<std::size_t>(slot)];
                if ((oriented ? facing : std::abs(facing)) < acrossCosine) {
                    code = acrossDisc;
                } else if (off > quiet * limit) {
                    const Vec3f outward = tangential(block.position(slot) - lanes.centroidAt(lane), n);
                    if (lengthSq(outward) > 0)
                        code = cutOf(surface, block.surfel(slot), outward, m_radiusOfSupport * block.support(slot), off,
                                     limit);
                }
                any = any || code != wholeDisc;
            }
            if (any)
                out[b] = std::make_unique<CutCodes>(codes);
        }
    });
    return out;
}

void DiscCuts::prepare(std::span<const SurfelBlock* const> blocks) {
    std::vector<const SurfelBlock*> fresh;
    for (const SurfelBlock* block : blocks)
        if (!m_codes.contains(block))
            fresh.push_back(block);
    if (fresh.empty())
        return;
    Found found = look(fresh);
    for (std::size_t i = 0; i < fresh.size(); ++i)
        m_codes.try_emplace(fresh[i], Kept{surfel::BlockPtr(fresh[i]), std::move(found[i])});
}

std::vector<const SurfelBlock*> DiscCuts::follow(const tree::SurfelTree& to) {
    std::vector<const SurfelBlock*> changed;
    const tree::SurfelTree from = std::exchange(m_model, to);
    if (m_codes.empty() || from == to)
        return changed;
    const tree::Diff diff = tree::diff(from, to);
    for (const surfel::BlockPtr& block : diff.removed)
        m_codes.erase(block.get());
    if (m_codes.empty())
        return changed;
    // Whoever is in the support of what came or went, from its place or from its disc's end.
    std::unordered_set<const SurfelBlock*> near;
    for (const auto* side : {&diff.removed, &diff.added})
        for (const surfel::BlockPtr& block : *side)
            to.forBlocksInSupport(
                block->box().inflated(block->maxSupport()),
                [&](std::uint32_t, const SurfelBlock& each) {
                    if (m_codes.contains(&each))
                        near.insert(&each);
                },
                m_radiusOfSupport);
    std::vector<const SurfelBlock*> all(near.begin(), near.end());
    Found found = look(all);
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::unique_ptr<CutCodes>& codes = m_codes.at(all[i]).codes;
        const bool same = codes && found[i] ? *codes == *found[i] : !codes && !found[i];
        if (!same)
            changed.push_back(all[i]);
        codes = std::move(found[i]);
    }
    return changed;
}

} // namespace render
