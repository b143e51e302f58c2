#include "core/selection/rims.h"

#include "core/selection/field.h"
#include "core/selection/links.h"
#include "core/surface/curves/boundary_curves.h"

namespace selection {

using base::Vec3d;

/// Squared distance of x to the part of a line from a to b.
static double distanceSqTo(const Vec3d& x, const Vec3d& a, const Vec3d& b) {
    const Vec3d d = b - a;
    const double sq = lengthSq(d), t = sq > 0 ? std::clamp(dot(x - a, d) / sq, 0.0, 1.0) : 0;
    return distanceSq(x, a + d * t);
}

template <class Fn>
static void forPieces(const surface::BoundaryCurve& curve, const Fn& fn) {
    const std::size_t n = curve.points.size();
    if (n == 1)
        fn(curve.points[0].position, curve.points[0].position);
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n && n > 1; ++i)
        fn(curve.points[i].position, curve.points[(i + 1) % n].position);
}

tree::Selection alongRims(const surface::Surface& surface, const RimQuestion& question,
                          const base::Progress& progress) {
    std::vector<surface::BoundaryCurve> curves = surface::findBoundaryCurves(surface, progress);
    std::erase_if(curves, [&](const surface::BoundaryCurve& curve) { return curve.length() > question.longest; });
    if (question.at && !curves.empty()) {
        double best = std::numeric_limits<double>::infinity();
        std::size_t nearest = 0;
        for (std::size_t c = 0; c < curves.size(); ++c)
            forPieces(curves[c], [&](const Vec3d& a, const Vec3d& b) {
                if (const double d = distanceSqTo(*question.at, a, b); d < best)
                    best = d, nearest = c;
            });
        curves = {curves[nearest]};
    }
    const Links links(surface);
    std::vector<std::bitset<surfel::blockCapacity>> found(surface.tree().blockCount());
    const auto width = static_cast<float>(question.width);
    for (const surface::BoundaryCurve& curve : curves)
        forPieces(curve, [&](const Vec3d& a, const Vec3d& b) {
            base::Box3f box;
            box.extend(base::cast<float>(a)), box.extend(base::cast<float>(b));
            const auto look = [&](std::uint32_t number, const surfel::SurfelBlock& block) {
                for (int slot = 0; slot < block.size(); ++slot) {
                    const double reach =
                        width > 0 ? question.width : static_cast<double>(links.lengthAt(block.support(slot)));
                    if (distanceSqTo(base::cast<double>(block.position(slot)), a, b) <= reach * reach)
                        found[number].set(static_cast<std::size_t>(slot));
                }
            };
            // Boundary points lie within a support of surfels; a width of its own is looked for in a wider box.
            surface.tree().forBlocksInSupport(width > 0 ? box.inflated(width) : box, look);
        });
    tree::Selection out;
    for (std::size_t b = 0; b < found.size(); ++b)
        if (found[b].any())
            out.push_back({static_cast<std::uint32_t>(b), found[b]});
    return out;
}

} // namespace selection
