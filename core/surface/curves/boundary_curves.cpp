#include "core/surface/curves/boundary_curves.h"

#include "core/base/parallel.h"
#include "core/surface/curves/curve_tracing.h"
#include "core/surface/curves/traced_lines.h"

namespace surface {

using base::Vec3d, base::Vec3f;

namespace {

/// In units of h: o from which a surfel may have a boundary near it. The last row of a regular sheet has 0.13
/// (surface/README 5.1).
constexpr double seedOffCentre = 0.1;
constexpr double seedReach = 1;   ///< in units of h: a boundary farther off is another surfel's
constexpr double onCurve = 0.02;  ///< in units of h: how far a point may be from the polyline of its curve
constexpr double sameCurve = 0.1; ///< in units of h: two curves that are so close for half their way are one
constexpr double atKinks = 0.08;  ///< in units of h: how far ways end from each other where rims have corners
constexpr std::size_t slab = 65536;

/// Boundary points by their surfels, in tree order.
std::vector<BoundaryPoint> findSeeds(const Surface& surface, const base::Progress& progress) {
    std::vector<Vec3f> x;
    surface.tree().forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
        for (int slot = 0; slot < block.size(); ++slot)
            x.push_back(block.position(slot));
    });
    const double limit = static_cast<double>(surface.definition().boundaryLimit);
    const double least = std::min(seedOffCentre, 0.5 * limit);
    std::vector<BoundaryPoint> out;
    std::vector<Evaluationf> at;
    std::vector<BoundarySearch> found;
    for (std::size_t from = 0; from < x.size(); from += slab) {
        progress.step(0.7 * static_cast<double>(from) / static_cast<double>(x.size()), "Looking for boundaries");
        const std::size_t n = std::min(slab, x.size() - from);
        at.assign(n, {});
        found.assign(n, {});
        surface.evaluate(std::span(x).subspan(from, n), Need::Value, at);
        base::parallelFor(n, 64, [&](std::size_t i) {
            if (!(at[i].status == Status::BeyondBoundary || at[i].ok()) ||
                !(static_cast<double>(at[i].offCentre) > least * static_cast<double>(at[i].unit)))
                return;
            const Vec3d start = base::cast<double>(x[from + i]);
            found[i] = findBoundaryPoint(surface, start);
            if (distance(found[i].point.position, start) > seedReach * found[i].point.unit)
                found[i].status = Status::NotConverged;
        });
        for (const BoundarySearch& each : found)
            if (each.ok())
                out.push_back(each.point);
    }
    return out;
}

/// The other open curve that goes on where the one at `i` ends: the nearest.
std::optional<std::pair<std::size_t, Kink>> successor(const std::vector<BoundaryCurve>& curves, std::size_t i) {
    std::optional<std::pair<std::size_t, Kink>> out;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const auto kink =
            k == i || curves[k].closed ? std::nullopt : kinkBetween(curves[i].points, curves[k].points, atKinks);
        if (kink && (!out || kink->apart < out->second.apart))
            out = {k, *kink};
    }
    return out;
}

/// Makes one curve of those that follow each other over kinks, and a loop where the last leads to the first.
void joinAtKinks(std::vector<BoundaryCurve>& curves) {
    for (std::size_t i = 0; i < curves.size();) {
        curves[i].closed = curves[i].closed || closeAtAKink(curves[i].points, atKinks);
        const auto next = curves[i].closed ? std::nullopt : successor(curves, i);
        if (!next) {
            ++i;
            continue;
        }
        const auto& [k, kink] = *next;
        std::vector<BoundaryPoint>&from = curves[k].points, &to = curves[i].points;
        to.resize(kink.upTo);
        to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(kink.from), from.end());
        curves[i].surfels += curves[k].surfels;
        curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(k));
        i -= k < i;
    }
}

} // namespace

std::vector<BoundaryCurve> findBoundaryCurves(const Surface& surface, const base::Progress& progress,
                                              const TraceOptions& options) {
    std::vector<BoundaryCurve> out;
    if (!std::isfinite(surface.definition().boundaryLimit) || surface.tree().empty())
        return out;
    const std::vector<BoundaryPoint> seeds = findSeeds(surface, progress);
    TracedLines traced;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (i % 64 == 0)
            progress.step(0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(seeds.size()),
                          "Following boundaries");
        std::ptrdiff_t place = traced.lineAt(seeds[i], onCurve);
        if (place < 0) {
            BoundaryCurve curve = traceBoundary(surface, seeds[i], options);
            place = traced.sameAs(curve.points, sameCurve);
            if (place < 0) {
                place = static_cast<std::ptrdiff_t>(out.size());
                traced.add(curve.points, curve.closed, out.size());
                out.push_back(std::move(curve));
            }
        }
        ++out[static_cast<std::size_t>(place)].surfels;
    }
    std::erase_if(out, [](const BoundaryCurve& curve) { return curve.points.size() < 2; }); // nowhere to go from there
    joinAtKinks(out);
    std::stable_sort(out.begin(), out.end(),
                     [](const BoundaryCurve& a, const BoundaryCurve& b) { return a.length() > b.length(); });
    return out;
}

} // namespace surface
