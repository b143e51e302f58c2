#include "core/solid/extrude/extruded_rims.h"

#include "core/process/estimation/known_rims.h"
#include "core/surface/rims.h"

#include <algorithm>

namespace solid {

using base::Vec3d;

namespace {

constexpr double step = 0.25; // h: rims are told to that

/// Does the model leave it to others to find where it ends, and do they know?
bool areTold(const surface::Surface& surface, std::span<const surface::BoundaryCurve> curves) {
    return process::mayKnowRims(surface) &&
           (surface::knowsRims(surface) ||
            std::ranges::all_of(curves, [](const surface::BoundaryCurve& each) { return each.closed; }));
}

void addLine(const Vec3d& from, const Vec3d& to, double apart, std::vector<Vec3d>& out) {
    const double pieces = std::max(1.0, std::ceil(distance(from, to) / apart));
    for (double k = 0; k <= pieces; ++k)
        out.push_back(from + (to - from) * (k / pieces));
}

} // namespace

std::vector<Vec3d> rimsWithPart(const surface::Surface& surface, const Part& part, const Vec3d& way,
                                const base::Progress& progress) {
    if (!std::isfinite(surface.definition().boundaryLimit))
        return {};
    const std::vector<surface::BoundaryCurve> curves = findBoundaryCurves(surface, progress);
    if (!areTold(surface, curves))
        return {};
    const std::vector<std::size_t> first = surface.tree().firstSurfels();
    const auto moves = [&](const Vec3d& x) {
        std::vector<tree::Neighbour> near;
        surface.tree().nearest(base::cast<float>(x), 1, near);
        return part.holds(first[near[0].blockNumber] + static_cast<std::size_t>(near[0].slot));
    };
    std::vector<Vec3d> out;
    for (const surface::BoundaryCurve& curve : curves) {
        bool last = moves(curve.closed ? curve.points.back().position : curve.points.front().position);
        for (const surface::BoundaryPoint& p : curve.points) {
            const bool now = moves(p.position);
            if (now != last) // a wall ends here
                addLine(p.position, p.position + way, step * p.unit, out);
            out.push_back(now ? p.position + way : p.position);
            last = now;
        }
    }
    return out;
}

std::vector<Vec3d> rimsWithWall(const surface::Surface& surface, std::span<const surface::BoundaryCurve> curves,
                                std::size_t number, const Loop& loop, std::span<const Vec3d> ways) {
    if (!areTold(surface, curves))
        return {};
    std::vector<Vec3d> out;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = 0; i != number && k < curves[i].points.size(); ++k)
            out.push_back(curves[i].points[k].position);
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t j = (i + 1) % loop.size();
        addLine(loop.points[i].position + ways[i], loop.points[j].position + ways[j], loop.points[i].spacing, out);
    }
    return out;
}

} // namespace solid
