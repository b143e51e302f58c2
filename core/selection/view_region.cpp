#include "core/selection/view_region.h"

#include "core/selection/hidden.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>

namespace selection {

using base::Vec3d;

ViewRegion::ViewRegion(const render::Camera& from, base::Outline in)
    : camera(from), outline(std::move(in)), m_forward(from.forward()), m_right(from.right()), m_upright(from.upright()),
      m_focal(from.focalPx()) {}

Vec3d ViewRegion::place(const Vec3d& x) const {
    const Vec3d v = x - camera.eye;
    const double z = dot(v, m_forward), f = m_focal / (camera.parallel() ? 1 : z);
    return {0.5 * camera.width + f * dot(v, m_right), 0.5 * camera.height - f * dot(v, m_upright), z};
}

bool ViewRegion::holds(const Vec3d& x) const {
    const Vec3d p = place(x);
    return p.z > 0 && p.z >= nearest && p.z <= farthest && outline.holds({p.x, p.y});
}

/// The picture of a box lies in the rectangle about those of its corners, as long as all of it lies before the eye.
Relation ViewRegion::relation(const base::Box3d& box) const {
    constexpr double inf = std::numeric_limits<double>::infinity(), slack = 1e-6; // of a pixel
    base::Point2 lo{inf, inf}, hi{-inf, -inf};
    double least = inf, most = -inf;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3d p = place(
            {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z});
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)}, hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
        least = std::min(least, p.z), most = std::max(most, p.z);
    }
    const double size = 1e-12 * (std::abs(most) + std::abs(least) + length(camera.eye));
    if (most < -size || most < nearest - size || least > farthest + size)
        return Relation::Outside;
    if (least <= size) // about the eye: pictures of it reach to infinity
        return Relation::Partly;
    const double grow = slack + 1e-12 * (std::abs(lo.x) + std::abs(lo.y) + std::abs(hi.x) + std::abs(hi.y));
    if (outline.meets({lo.x - grow, lo.y - grow}, {hi.x + grow, hi.y + grow}))
        return Relation::Partly;
    if (!outline.holds({0.5 * (lo.x + hi.x), 0.5 * (lo.y + hi.y)}))
        return Relation::Outside;
    return least >= nearest + size && most <= farthest - size ? Relation::Inside : Relation::Partly;
}

tree::Selection visibleOf(const surface::Surface& surface, const render::Camera& camera, const tree::Selection& found) {
    const surface::Surface seen = shownOf(surface);
    const std::vector<const surfel::SurfelBlock*> blocks = blocksOf(surface.tree());
    const bool oriented = surface.tree().layout()->oriented;
    const Vec3d forward = camera.forward();
    constexpr double sameSurface = 1e-3; // in units of h: the tolerance of pictures
    tree::Selection out = found;
    base::parallelFor(out.size(), 1, [&](std::size_t b) {
        const surfel::SurfelBlock& block = *blocks[out[b].block];
        std::vector<base::Rayf> rays;
        std::vector<int> slots;
        std::vector<double> depths;
        for (int slot = 0; slot < block.size(); ++slot) {
            if (!out[b].slots[static_cast<std::size_t>(slot)])
                continue;
            const Vec3d x = base::cast<double>(block.position(slot)), to = x - camera.eye;
            const double depth = camera.parallel() ? dot(to, forward) : length(to);
            const Vec3d direction = camera.parallel() ? forward : normalized(to, forward);
            slots.push_back(slot);
            depths.push_back(depth);
            rays.push_back({base::cast<float>(x - direction * depth), base::cast<float>(direction)});
        }
        std::vector<surface::RayHit<float>> hits(rays.size());
        surface::IntersectOptions options;
        options.tolerance = sameSurface;
        surface::intersect(seen, rays, options, hits);
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const double support = static_cast<double>(block.support(slots[i]));
            const double before = hits[i].hit ? depths[i] - static_cast<double>(hits[i].t) : 0;
            const base::Vec3f n = block.normal(slots[i]);
            const bool alike = !oriented || (dot(hits[i].outward, n) > 0 && dot(rays[i].direction, n) < 0);
            if (before > (alike ? support : 10 * sameSurface * support))
                out[b].slots.reset(static_cast<std::size_t>(slots[i]));
        }
    });
    std::erase_if(out, [](const tree::SelectedBlock& block) { return block.slots.none(); });
    return out;
}

} // namespace selection
