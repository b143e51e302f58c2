#include "core/render/splats/finer_discs.h"

#include "core/render/splats/label_cuts.h"
#include "core/surface/rays/intersect.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace render {

using base::Vec3f;
using surfel::SurfelBlock;
using FootFound = surface::Projection<float>;

namespace {

constexpr surface::ProjectOptions projector{.projector = surface::Projector::Almost, .tolerance = 1e-5};
/// Patches are sure of what lies within their feet, in radii.
constexpr float withinFeet = 0.76f;
/// Patches lie off their feet by less, and what is checked beyond them by twice as much, in pixels.
constexpr float patchOff = 0.25f;
/// Straight rims have more surfels in support: half of the usual 38.
constexpr int fewAbout = 16;
/// A foot farther off than this part of the radius is on another sheet.
constexpr float nearFoot = 1;

/// One of the finer discs of another, `place` radii off its middle, both in its plane.
FinerDisc finerOf(const FinerDisc& of, float radius, const Vec3f& place, int rings) {
    FinerDisc out = of;
    const Vec3f along = normalized(of.shape - of.surfel.normal * dot(of.shape, of.surfel.normal), Vec3f{});
    const float narrower = 1 - 1 / surfel::aspectOf(of.shape);
    out.surfel.support *= spreadRadius(rings);
    out.surfel.position += (place - along * (dot(along, place) * narrower)) * radius;
    return out;
}

/// Brings a disc to its foot. False where there is none near by: the surface has ended before, or is another sheet.
bool settleAt(surfel::Surfel& disc, const FootFound& foot, float radius) {
    if (!foot.ok() || distance(foot.foot, disc.position) > nearFoot * radius)
        return false;
    const Vec3f n = normalized(foot.at.gradient, disc.normal);
    disc.position = foot.foot;
    disc.normal = dot(n, disc.normal) < 0 ? -n : n;
    return true;
}

} // namespace

FinerDiscs::FinerDiscs(const surface::Surface& surface, const cells::CellSurface* cells, float radiusOfSupport)
    : m_surface(surface), m_radius(radiusOfSupport), m_shape(surfel::shapeChannel(*surface.tree().layout())),
      m_labels(cells ? &cells->labels() : nullptr) {
    if (cells)
        m_cells.emplace(*cells, radiusOfSupport);
}

FinerDisc FinerDiscs::discOf(const SurfelBlock& block, int i) const {
    return {block.surfel(i), surfel::shapeOf(block, i, m_shape)};
}

FinerDiscs::Spread FinerDiscs::footed(const SurfelBlock& block, std::span<const std::optional<Plan>> plans) const {
    Spread out;
    std::vector<Vec3f> places;
    for (int i = 0; i < block.size(); ++i) {
        const auto slot = static_cast<std::size_t>(i);
        if (const auto& plan = plans[slot])
            for (const Vec3f& each : spreadPlaces(block.normal(i), plan->rings, plan->ends)) {
                out.inPlane.push_back(each);
                places.push_back(finerOf(discOf(block, i), radiusOf(block, i), each, plan->rings).surfel.position);
            }
        out.first[slot + 1] = places.size();
    }
    out.feet.resize(places.size());
    surface::project(m_surface, places, projector, out.feet);
    return out;
}

/// By what the seven feet about a surfel tell: where one is missing the surface ends, or is none that rays would hit,
/// and their heights over each other's planes are those by which the disc stands out.
FinerDiscs::Plan FinerDiscs::planOf(const SurfelBlock& block, int i, Feet seven, const FinerWay& way) const {
    if (m_cells || !(way.pixel > 0) || seven.size() < 7)
        return {};
    const float radius = radiusOf(block, i);
    SeenDisc seen{radius / way.pixel, 0, way.ends && (*way.ends)[static_cast<std::size_t>(i)] != wholeDisc};
    const FootFound& middle = seven.front();
    for (const FootFound& foot : seven) {
        if (!isSettled(block, i, foot) || !isSettled(block, i, middle)) {
            seen.ends = true;
            continue;
        }
        const Vec3f apart = foot.foot - middle.foot;
        const float off = std::max(std::abs(dot(apart, normalized(middle.at.gradient, Vec3f{}))),
                                   std::abs(dot(apart, normalized(foot.at.gradient, Vec3f{}))));
        const float far = std::max(lengthSq(apart), 0.25f * radius * radius);
        seen.standOut = std::max(seen.standOut, off * radius * radius / (far * way.pixel));
    }
    return {spreadRings(seen), seen.ends, seen.ends && middle.at.samples < fewAbout};
}

std::vector<FinerDisc> FinerDiscs::of(const SurfelBlock& block, const FinerWay& way) {
    std::array<std::optional<Plan>, surfel::blockCapacity> first, second;
    for (int i = 0; i < block.size(); ++i) {
        const bool small = !m_cells && way.pixel > 0 && spreadRings({radiusOf(block, i) / way.pixel, 0, false}) == 0;
        first[static_cast<std::size_t>(i)] = Plan{small ? 0 : 1, false};
    }
    const Spread seven = footed(block, first);
    const float off = patchOff * way.pixel;
    std::array<std::optional<SmoothPatch>, surfel::blockCapacity> patches;
    std::array<Plan, surfel::blockCapacity> plans;
    for (int i = 0; i < block.size(); ++i) {
        const auto slot = static_cast<std::size_t>(i);
        plans[slot] = first[slot]->rings > 0 ? planOf(block, i, seven.feetOf(i), way) : *first[slot];
        if (plans[slot].rings > 1 && !plans[slot].loose)
            patches[slot] = patchOf(block, i, seven.feetOf(i), off);
        if (plans[slot].rings > 1 && !patches[slot])
            second[slot] = plans[slot];
    }
    const Spread all = footed(block, second);
    std::vector<FinerDisc> out;
    CutCodes own{};
    bool cut = false;
    for (int i = 0; i < block.size(); ++i) {
        const auto slot = static_cast<std::size_t>(i);
        const std::size_t before = out.size();
        if (patches[slot])
            addSmooth(block, i, plans[slot], *patches[slot], 2 * off, out);
        else
            addFooted(block, i, plans[slot].rings, second[slot] ? all : seven, out);
        if (out.size() > before)
            continue;
        out.push_back(discOf(block, i));
        if (m_labels && !std::exchange(cut, true))
            LabelCuts(m_surface.tree(), *m_labels, m_radius).cut(block, own);
        out.back().code = own[slot];
    }
    return out;
}

std::vector<FinerDisc> FinerDiscs::settled(const SurfelBlock& block) const {
    std::vector<Vec3f> places;
    for (int i = 0; i < block.size(); ++i)
        places.push_back(block.position(i));
    std::vector<FootFound> feet(places.size());
    surface::project(m_surface, places, projector, feet);
    std::vector<FinerDisc> out;
    for (int i = 0; i < block.size(); ++i) {
        out.push_back(discOf(block, i));
        settleAt(out.back().surfel, feet[static_cast<std::size_t>(i)], (finerReach - 1) * radiusOf(block, i));
    }
    return out;
}

/// Whether a place of the seven about a surfel has come to rest on its sheet.
bool FinerDiscs::isSettled(const SurfelBlock& block, int i, const FootFound& foot) const {
    return foot.ok() && surface::isSurface(foot.at) &&
           distance(foot.foot, block.position(i)) <= spreadReach * radiusOf(block, i);
}

std::optional<SmoothPatch> FinerDiscs::patchOf(const SurfelBlock& block, int i, Feet found, float most) const {
    std::array<Foot, 7> feet;
    if (found.size() != feet.size())
        return std::nullopt;
    for (std::size_t k = 0; k < feet.size(); ++k) {
        if (!isSettled(block, i, found[k]))
            return std::nullopt;
        surfel::Surfel each = block.surfel(i);
        settleAt(each, found[k], spreadReach * radiusOf(block, i));
        feet[k] = {each.position, each.normal};
    }
    return SmoothPatch::through(feet, radiusOf(block, i), most);
}

/// Is the surface within `most` of x, to first order?
bool FinerDiscs::isOn(const Vec3f& x, float most) const {
    const surface::Evaluationf at = m_surface.evaluate(x, surface::Need::Gradient);
    return surface::isSurface(at) && std::abs(at.value) <= most * length(at.gradient);
}

/// Beyond its feet the patch is checked, and within them where the surface ends.
void FinerDiscs::addSmooth(const SurfelBlock& block, int i, const Plan& plan, const SmoothPatch& patch, float most,
                           std::vector<FinerDisc>& out) const {
    const FinerDisc disc = discOf(block, i);
    for (const Vec3f& each : spreadPlaces(disc.surfel.normal, plan.rings, false)) {
        FinerDisc finer = finerOf(disc, radiusOf(block, i), each, plan.rings);
        const Foot foot = patch.at(finer.surfel.position);
        finer.surfel.position = foot.position, finer.surfel.normal = foot.normal;
        if ((plan.ends || lengthSq(each) > withinFeet * withinFeet) && !isOn(foot.position, most))
            continue;
        out.push_back(finer);
    }
}

void FinerDiscs::addFooted(const SurfelBlock& block, int i, int rings, const Spread& spread,
                           std::vector<FinerDisc>& out) {
    const float radius = radiusOf(block, i);
    const FinerDisc whole = discOf(block, i);
    const bool edge =
        m_cells && m_cells->endsWithin(block.position(i), m_labels->cellAt(block, i), spreadReach * radius);
    const std::size_t first = spread.first[static_cast<std::size_t>(i)];
    const Feet feet = spread.feetOf(i);
    for (std::size_t k = 0; k < feet.size(); ++k) {
        const Vec3f& place = spread.inPlane[first + k];
        FinerDisc disc = finerOf(whole, radius, place, rings);
        bool settled = settle(disc, block, i, edge, &feet[k]);
        if (!settled && k > 0 && lengthSq(place) <= 1) {
            disc = finerOf(whole, radius, fartherIn(place, rings), rings);
            settled = settle(disc, block, i, edge, nullptr);
        }
        if (settled)
            out.push_back(disc);
    }
}

/// `ends`: an edge is near. `foot`: on the smooth surface, where that is known.
bool FinerDiscs::settle(FinerDisc& disc, const SurfelBlock& block, int i, bool ends, const FootFound* foot) {
    const float radius = radiusOf(block, i);
    if (m_cells && m_cells->concerns(disc.surfel.position)) {
        const std::uint32_t cell = m_labels->cellAt(block, i);
        return ends ? m_cells->settle(disc.surfel, cell, nearFoot * radius, disc.code)
                    : m_cells->place(disc.surfel, cell, nearFoot * radius);
    }
    const FootFound found = foot ? *foot : surface::project(m_surface, disc.surfel.position, projector);
    return (m_cells || surface::isSurface(found.at)) && settleAt(disc.surfel, found, radius);
}

} // namespace render
