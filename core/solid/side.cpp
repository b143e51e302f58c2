#include "core/solid/side.h"

#include "core/base/parallel.h"
#include "core/cells/cell_projection.h"
#include "core/surface/rays/intersect.h"

namespace solid {

using base::Vec3d;
using base::Vec3f;

/// Odd directions, so that no ray runs along what was built along axes.
static constexpr Vec3f directions[] = {{0.5377F, 0.6142F, 0.5776F},
                                       {-0.7313F, 0.4051F, -0.5487F},
                                       {0.2214F, -0.8317F, 0.5091F},
                                       {0.6803F, -0.1529F, -0.7168F},
                                       {-0.3321F, -0.5023F, -0.7984F}};

/// The first hit from inside is on a surface that faces along the ray. Most of the rays tell: all five where the first
/// three do not agree.
static bool inside(const surface::Surface& surface, const Vec3f& x) {
    int votes = 0, asked = 0;
    for (const Vec3f& direction : directions) {
        const Vec3f unit = normalized(direction);
        const surface::RayHit<float> hit = surface::intersect(surface, {x, unit}, {.tolerance = 1e-3});
        votes += hit.hit && dot(hit.outward, unit) > 0;
        ++asked;
        if (asked == 3 && (votes == 0 || votes == 3))
            break;
    }
    return 2 * votes > asked;
}

/// Is there any crease? Labels alone, as those of one cell, change nothing.
static bool hasCreases(const tree::SurfelTree& tree) {
    const std::optional<cells::LabelLayout> layout = cells::LabelLayout::of(*tree.layout());
    bool any = false;
    if (layout)
        tree.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; !any && slot < block.size(); ++slot) {
                const cells::Label label = layout->at(block, slot);
                any = label.partner != label.cell;
            }
        });
    return any;
}

SurfaceSide::SurfaceSide(surface::Surface surface) : m_surface(std::move(surface)) {
    if (hasCreases(m_surface.tree()))
        m_cells = cells::CellSurface::of(m_surface);
}

template <class T>
static SideValue nearValue(const surface::Evaluation<T>& at) {
    const auto slope = static_cast<double>(length(at.gradient));
    return {static_cast<double>(at.value) / slope, base::cast<double>(at.gradient) / slope, true};
}

SideValue SurfaceSide::at(const Vec3d& x) const {
    const Vec3f place = base::cast<float>(x);
    if (m_cells) {
        const cells::CellValue value = cells::evaluate(*m_cells, x, surface::Need::Gradient);
        if (value.mixed && (value.at.ok() || value.at.status == surface::Status::BeyondBoundary))
            return nearValue(value.at); // the smooth one would be round
    }
    const surface::Evaluationf at = m_surface.evaluate(place, surface::Need::Gradient);
    if (surface::isSurface(at))
        return nearValue(at);
    return {inside(m_surface, place) ? -1.0 : 1.0, {}, false};
}

SideFoot SurfaceSide::foot(const Vec3d& x) const {
    surface::ProjectOptions options;
    options.checkBoundary = false;
    surface::Projection<double> found;
    if (m_cells)
        found = cells::project(*m_cells, x, options).projection;
    if (!found.ok())
        found = surface::projectReference(m_surface, x, options);
    if (!found.ok())
        return {};
    const Vec3d up = x - found.foot, normal = normalized(found.at.gradient);
    const double apart = length(up);
    // at an edge no cell's gradient leads to x; on the surface nothing else does
    if (apart < 1e-6 * found.at.unit)
        return {found.foot, dot(up, normal), normal, true};
    const double sign = dot(up, normal) < 0 ? -1 : 1;
    return {found.foot, sign * apart, up * (sign / apart), true};
}

bool SurfaceSide::meets(const base::Box3d& box) const {
    bool any = false;
    m_surface.tree().forBlocksInSupport({base::cast<float>(box.lo), base::cast<float>(box.hi)},
                                        [&](std::uint32_t, const surfel::SurfelBlock&) { any = true; });
    return any;
}

std::vector<std::int8_t> sidesOf(const tree::SurfelTree& tree, const Side& side) {
    constexpr double onSurface = 0.1, parallel = 0.9;
    const std::vector<std::size_t> first = tree.firstSurfels();
    std::vector<std::int8_t> out(tree.size());
    base::parallelFor(tree.blockCount(), 1, [&](std::size_t b) {
        const surfel::BlockPtr held = tree.block(static_cast<std::uint32_t>(b));
        const surfel::SurfelBlock& block = *held;
        const base::Box3f box = block.box().inflated(1e-3F * block.maxSupport());
        const bool one = !side.meets({base::cast<double>(box.lo), base::cast<double>(box.hi)});
        const std::int8_t all = !one || side.at(base::cast<double>(block.position(0))).value > 0 ? 1 : -1;
        for (int slot = 0; slot < block.size(); ++slot) {
            std::int8_t& result = out[first[b] + static_cast<std::size_t>(slot)];
            result = all;
            if (one)
                continue;
            const SideValue at = side.at(base::cast<double>(block.position(slot)));
            const double spacing = static_cast<double>(block.support(slot)) * surface::spacingOfUnit,
                         facing = dot(at.gradient, base::cast<double>(block.normal(slot)));
            result = at.value > 0 ? 1 : -1;
            if (at.near && std::abs(at.value) < onSurface * spacing && std::abs(facing) > parallel)
                result = facing > 0 ? 2 : -2;
        }
    });
    return out;
}

} // namespace solid
