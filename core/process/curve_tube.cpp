#include "core/process/curve_tube.h"

#include "core/base/parallel.h"
#include "core/surface/curves/curve.h"

#include <numbers>

namespace process {

using base::Vec3d;
using surface::Surface;

namespace {

constexpr int around = 16; ///< surfels of a ring
constexpr double radiusOfSupport = 1.0 / 8;
constexpr double supportOfStep = 2.6; ///< about 21 neighbours, over no more than a radius
constexpr int mostRings = 64;         ///< of one surfel: a thin tube between distant points stays affordable
constexpr std::size_t nearby = 12;    ///< neighbours looked at for the next point on either side

/// How far the next point is along the curve on one side, and its radius.
struct Side {
    double gap = 0, radius = 0;
};

class TubeMaker {
  public:
    explicit TubeMaker(const Surface& curve) : m_curve(curve), m_radius(curve.tree().layout()->find("radius")) {}

    /// The rings that stand for one surfel: from half way to the point before to half way to the one after.
    void addRings(const surfel::SurfelBlock& block, int slot, std::vector<surfel::Surfel>& out) const {
        const surfel::Surfel own = block.surfel(slot);
        const surface::CurveProjection at = foot(base::cast<double>(own.position));
        if (!at.ok())
            return;
        const double radius = radiusOf(block, slot);
        Side sides[2] = {};
        measure(own, at.at.tangent, sides);
        const double step = 2 * std::numbers::pi * radius / around, begin = -0.5 * sides[0].gap;
        const double reach = 0.5 * (sides[0].gap + sides[1].gap);
        const int rings = std::clamp(static_cast<int>(std::ceil(reach / step)), 1, mostRings);
        for (int ring = 0; ring < rings; ++ring) {
            const double along = begin + reach * (ring + 0.5) / rings;
            const Side& side = sides[along < 0 ? 0 : 1];
            const double slope = side.gap > 0 ? (side.radius - radius) / side.gap : 0;
            const surface::CurveProjection on = foot(at.foot + at.at.tangent * along);
            if (on.ok())
                addRing(own, on, radius + slope * std::abs(along), along < 0 ? -slope : slope, out);
        }
    }

  private:
    surface::CurveProjection foot(const Vec3d& x) const {
        return projectOnCurve(m_curve, x, {surface::Projector::Basic, 1e-6, 30, true, surface::Need::Gradient});
    }

    double radiusOf(const surfel::SurfelBlock& block, int slot) const {
        const double fallback = radiusOfSupport * static_cast<double>(block.support(slot));
        if (!m_radius)
            return fallback;
        std::vector<std::uint32_t> words(block.extraWords());
        block.extra(slot, words);
        const double radius = read(*m_radius, words);
        return std::isfinite(radius) && radius > 0 ? radius : fallback;
    }

    /// The nearest points ahead and behind. A side without one is an end of the curve: it is covered half a step far.
    void measure(const surfel::Surfel& own, const Vec3d& tangent, Side (&sides)[2]) const {
        std::vector<tree::Neighbour> near;
        m_curve.tree().nearest(own.position, nearby, near, own.support);
        for (const tree::Neighbour& each : near) {
            const Vec3d q = base::cast<double>(each.block->position(each.slot) - own.position);
            const double away = length(q), along = dot(q, tangent);
            Side& side = sides[along < 0 ? 0 : 1];
            if (away > 0 && std::abs(along) > 0.5 * away && side.gap == 0)
                side = {away, radiusOf(*each.block, each.slot)};
        }
        for (int i = 0; i < 2; ++i)
            if (sides[i].gap == 0)
                sides[i] = {sides[1 - i].gap, radiusOf(*near[0].block, near[0].slot)};
    }

    static void addRing(const surfel::Surfel& own, const surface::CurveProjection& on, double radius, double slope,
                        std::vector<surfel::Surfel>& out) {
        const Vec3d& t = on.at.tangent;
        const Vec3d u = base::perpendicular(t), v = cross(t, u);
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            const Vec3d away = u * std::cos(angle) + v * std::sin(angle);
            surfel::Surfel s = own;
            s.position = base::cast<float>(on.foot + away * radius);
            s.normal = base::cast<float>(base::normalized(away - t * slope));
            s.support = static_cast<float>(supportOfStep * 2 * std::numbers::pi * radius / around);
            out.push_back(s);
        }
    }

    const Surface& m_curve;
    const surfel::Attribute* m_radius;
};

} // namespace

Surface tubeAround(const Surface& curve, const base::Progress& progress) {
    const TubeMaker maker(curve);
    const std::uint32_t blocks = curve.tree().blockCount();
    std::vector<std::vector<surfel::Surfel>> rings(blocks);
    constexpr std::uint32_t slab = 64;
    for (std::uint32_t first = 0; first < blocks; first += slab) {
        progress.step(static_cast<double>(first) / blocks, "Drawing the curve as a tube");
        base::parallelFor(std::min(slab, blocks - first), 1, [&](std::size_t i) {
            const surfel::BlockPtr block = curve.tree().block(first + static_cast<std::uint32_t>(i));
            for (int slot = 0; slot < block->size(); ++slot)
                maker.addRings(*block, slot, rings[first + i]);
        });
    }
    surfel::SurfelList list;
    auto layout = std::make_shared<surfel::AttributeLayout>();
    layout->normals = layout->oriented = true;
    layout->colours = curve.tree().layout()->colours;
    layout->masks = curve.tree().layout()->masks;
    list.layout = std::move(layout);
    for (const auto& each : rings)
        list.items.insert(list.items.end(), each.begin(), each.end());
    return {tree::SurfelTree::build(list), {}};
}

Surface shownAs(const Surface& model, const base::Progress& progress) {
    return model.definition().manifold == surface::Manifold::Curve ? tubeAround(model, progress) : model;
}

} // namespace process
