#include "core/render/splats/boundary_cuts.h"
#include "core/surface/rims.h"

#include <numbers>
#include <optional>

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
surface::Surface plainly(const tree::SurfelTree& model, surface::SurfaceDefinition definition) {
    definition.frame = surface::Frame::Normals;
    definition.oneSheet = false;
    definition.boundary = surface::Boundary::None;
    definition.boundaryLimit = std::numeric_limits<float>::infinity();
    return {model, definition};
}

/// The same as if normals had a common sign, which is fastest: it fails only where they cancel.
surface::Surface fastestOf(const surface::Surface& plain) {
    if (plain.tree().layout()->oriented)
        return plain;
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

/// Too few surfels have weight for a plane, so that nothing is surface about the place.
bool isLone(surface::Cause cause) {
    return cause == surface::Cause::NoSupport || cause == surface::Cause::OnePoint || cause == surface::Cause::TooFew;
}

Vec3f tangential(const Vec3f& v, const Vec3f& n) {
    return normalized(v - n * dot(n, v), Vec3f{});
}

/// Where a way that begins at value `here`, below the limit, reaches it.
struct WayEnd {
    float part = 0;            ///< of the way, as it was asked
    std::optional<Vec3f> away; ///< from the centroid, at the last place that had one
};

/// By regula falsi, from 0 to `far`; nothing where the limit is not reached within that. `at`: Around of a part.
template <class At>
std::optional<WayEnd> endOfWay(const At& at, float here, float far, float limit) {
    float low = 0, lowValue = here, high = far, highValue = at(far).value;
    if (!(highValue > limit))
        return std::nullopt;
    WayEnd out;
    for (int step = 0; step < 5; ++step) {
        const float between = std::isfinite(highValue) ? (limit - lowValue) / (highValue - lowValue) : 0.5f;
        const float middle = low + (high - low) * std::clamp(between, 0.1f, 0.9f);
        const Around found = at(middle);
        (found.value <= limit ? low : high) = middle;
        (found.value <= limit ? lowValue : highValue) = found.value;
        if (std::isfinite(found.value))
            out.away = found.away;
    }
    out.part = 0.5f * (low + high);
    return out;
}

/// The cut of a disc whose centre is off centre by `here` along the tangential direction `out`: the place along it
/// where the value reaches the limit, and the direction of the boundary there.
CutCode boundaryCut(const surface::Surface& surface, const surfel::Surfel& s, const Vec3f& out, float radius,
                    float here, float limit) {
    if (here >= limit)
        return cutCode(s.normal, out, leastPart);
    const auto end =
        endOfWay([&](float part) { return around(surface, s.position + out * (radius * part)); }, here, 1, limit);
    if (!end)
        return wholeDisc;
    const Vec3f direction = end->away ? tangential(*end->away, s.normal) : out;
    const float along = dot(direction, out);
    return along > 0.2f ? cutCode(s.normal, direction, end->part * along) : cutCode(s.normal, out, end->part);
}

/// The cut of a disc beside a rim that the model knows of. Where surfels are few the centroid of those about one tells
/// nothing of the rim's direction: of reduced models it is a tenth of a support aside of rims' own, whichever way. So
/// the disc's edge is looked along for where it is past the limit, and the rim is the line through what is found on
/// both sides of the middle of that.
CutCode knownRimCut(const surface::Surface& surface, const surfel::Surfel& s, float radius, float here, float limit) {
    constexpr int looks = 12;
    constexpr float aside = 0.6f, farther = 1.25f; // radians; radii
    const Vec3f u = discAxis(s.normal), v = cross(s.normal, u);
    Vec3f past;
    for (int k = 0; k < looks; ++k) {
        const float angle = static_cast<float>(k) * (2 * std::numbers::pi_v<float> / looks);
        const Vec3f way = u * std::cos(angle) + v * std::sin(angle);
        if (around(surface, s.position + way * radius).value > limit)
            past += way;
    }
    const Vec3f out = normalized(past, Vec3f{}), side = cross(s.normal, out);
    if (!(lengthSq(out) > 0))
        return wholeDisc;
    const auto rimAlong = [&](const Vec3f& way) {
        return endOfWay([&](float far) { return around(surface, s.position + way * far); }, here, farther * radius,
                        limit);
    };
    std::optional<Vec3f> rim[2];
    for (int k = 0; k < 2; ++k) {
        const Vec3f way = out * std::cos(aside) + side * ((k == 0 ? 1 : -1) * std::sin(aside));
        if (const auto found = rimAlong(way))
            rim[k] = way * found->part;
    }
    if (!rim[0] || !rim[1])
        return boundaryCut(surface, s, out, radius, here, limit);
    const Vec3f direction = normalized(cross(*rim[0] - *rim[1], s.normal), out);
    float part = dot(direction, *rim[0]) / radius;
    if (const auto middle = rimAlong(out)) // where it bulges
        part = std::max(part, dot(direction, out) * middle->part / radius);
    return part < 1 ? cutCode(s.normal, direction, part) : wholeDisc;
}

} // namespace

BoundarySubject::BoundarySubject(const tree::SurfelTree& model, const surface::SurfaceDefinition& definition,
                                 float radiusOfSupport)
    : plain(plainly(model, definition)), fastest(fastestOf(plain)), radius(radiusOfSupport),
      limit(definition.boundaryLimit), oriented(model.layout()->oriented), knowsRims(surface::knowsRims(plain)) {}

CutCode BoundaryCuts::cutOf(const SurfelBlock& block, int slot, surface::SelfLanes& lanes, bool onSurface) const {
    const int lane = slot % surfel::clusterSize;
    if (lanes.status[lane] != surface::Status::Ok) {
        const surface::Evaluationf e = m_of.plain.evaluate(block.position(slot), surface::Need::Value);
        if (isLone(e.cause))
            return loneDisc;
        if (m_of.oriented || !e.ok())
            return wholeDisc; // it has no plane
        lanes.set(lane, e);
    }
    const Vec3f n = block.normal(slot);
    if (lengthSq(n) < 0.25f)
        return wholeDisc;
    const float facing = dot(n, lanes.normalAt(lane)), off = lanes.offCentre[lane] / lanes.unit[lane];
    if (!onSurface && (m_of.oriented ? facing : std::abs(facing)) < acrossCosine)
        return acrossDisc;
    const bool known = m_of.knowsRims && off < m_of.limit;
    if (!(off > quiet * m_of.limit || known) || !surface::mayEnd(m_of.plain, block.position(slot)))
        return wholeDisc;
    const float reach = m_of.radius * block.support(slot);
    if (known)
        return knownRimCut(m_of.plain, block.surfel(slot), reach, off, m_of.limit);
    const Vec3f outward = tangential(block.position(slot) - lanes.centroidAt(lane), n);
    if (!(lengthSq(outward) > 0))
        return wholeDisc;
    return boundaryCut(m_of.plain, block.surfel(slot), outward, reach, off, m_of.limit);
}

bool BoundaryCuts::cut(const SurfelBlock& block, CutCodes& codes, bool onSurface) {
    surface::SelfLanes at[surfel::clustersPerBlock];
    m_self.evaluate(block, block.clusterMask(), surface::Need::Value, at);
    bool any = false;
    for (int slot = 0; slot < block.size(); ++slot) {
        CutCode& code = codes[static_cast<std::size_t>(slot)];
        code = cutOf(block, slot, at[slot / surfel::clusterSize], onSurface);
        any |= code != wholeDisc;
    }
    return any;
}

} // namespace render
