#include "core/selection/shell.h"

#include "core/base/error.h"
#include "core/process/estimation/boundary_limit.h"
#include "core/selection/links.h"
#include "core/selection/shape.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surfel/shape.h"

#include <algorithm>

namespace selection {

using base::Vec3d;

namespace {

constexpr std::size_t fewest = 16;

/// The part as a surface of its own, with the boundary limit that fits it where the model leaves that open.
surface::Surface aloneOf(const surface::Surface& surface, Limit limit, const base::Progress& progress) {
    surfel::SurfelList points = partOf(surface.tree(), limit == Limit::Selection);
    if (limit == Limit::Everything) {
        surfel::SurfelList rest = partOf(surface.tree(), true);
        points.items.insert(points.items.end(), rest.items.begin(), rest.items.end());
        points.extra.insert(points.extra.end(), rest.extra.begin(), rest.extra.end());
    }
    if (points.size() < fewest)
        throw base::Error("fewer than " + std::to_string(fewest) + " surfels are selected", {}, "select more");
    for (surfel::Surfel& s : points.items)
        s.mask = 0;
    return process::withOwnLimit(tree::SurfelTree::build(points, progress), surface.definition(), progress);
}

/// Rows of surfels between a boundary and where it comes to lie, as dense as the surface is there.
void addWall(const surface::Surface& part, const surface::BoundaryCurve& curve, double by, surfel::SurfelList& out) {
    const float perSupport = spacingsPerSupport(part.definition());
    const std::size_t n = curve.points.size(), pieces = curve.closed ? n : n - 1;
    std::vector<tree::Neighbour> near;
    std::vector<std::uint32_t> words(out.layout->words());
    double walked = 0, next = 0;
    for (std::size_t i = 0; i < pieces; ++i) {
        const surface::BoundaryPoint &a = curve.points[i], &b = curve.points[(i + 1) % n];
        const double length = distance(a.position, b.position);
        for (; next < walked + length;) {
            const double t = (next - walked) / length;
            const Vec3d p = a.position + (b.position - a.position) * t;
            const Vec3d up = normalized(a.normal + (b.normal - a.normal) * t);
            const Vec3d outward = normalized(a.outward + (b.outward - a.outward) * t);
            part.tree().nearest(base::cast<float>(p), 1, near);
            surfel::Surfel s = near[0].block->surfel(near[0].slot);
            near[0].block->extra(near[0].slot, words);
            surfel::becomeBall(*out.layout, s, words);
            const double spacing = std::max(static_cast<double>(s.support * perSupport), 0.01 * a.unit);
            const int rows = std::max(1, static_cast<int>(std::lround(std::abs(by) / spacing)));
            for (int row = 0; row < rows; ++row) {
                s.position = base::cast<float>(p + up * (by * (row + 0.5) / rows));
                s.normal = base::cast<float>(outward);
                out.append(s, words);
            }
            next += spacing;
        }
        walked += length;
    }
}

} // namespace

surface::Surface shellOf(const surface::Surface& surface, double thickness, ShellSide side, Limit limit,
                         const base::Progress& progress) {
    if (!surface.tree().layout()->oriented)
        throw base::Error("the normals have no sides, which tell outwards from inwards", {}, "orient them first");
    const surface::Surface part = aloneOf(surface, limit, progress);
    if (thickness > static_cast<double>(part.tree().bounds().diagonal()))
        throw base::Error("the shell would be thicker than what it is made of is large", {}, "ask for less");
    const double by = side == ShellSide::In ? -thickness : thickness;
    const surface::Surface other = raised(
        part,
        [by](const Vec3d&) {
            return Height{by, {}};
        },
        Limit::Everything, progress);
    const surface::Surface &outer = side == ShellSide::In ? part : other, &inner = side == ShellSide::In ? other : part;
    surfel::SurfelList out = outer.tree().surfels();
    const surfel::SurfelList turned = flipped(inner.tree(), Limit::Everything).surfels();
    out.items.insert(out.items.end(), turned.items.begin(), turned.items.end());
    out.extra.insert(out.extra.end(), turned.extra.begin(), turned.extra.end());
    for (const surface::BoundaryCurve& curve : surface::findBoundaryCurves(part, progress))
        addWall(part, curve, by, out);
    return process::withOwnLimit(tree::SurfelTree::build(out, progress), part.definition(), progress);
}

} // namespace selection
