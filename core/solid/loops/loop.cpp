#include "core/solid/loops/loop.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/process/resampling/point_grid.h"
#include "core/surface/projection/project.h"

#include <algorithm>
#include <limits>

namespace solid {

using base::Vec3d;

double Loop::meanSpacing() const {
    double sum = 0;
    for (const LoopPoint& p : points)
        sum += p.spacing;
    return sum / static_cast<double>(points.size());
}

struct Sampling {
    double spacing = 0, support = 0;
};

/// About a place: medians over the nearest surfels, so that a stray one has no say.
static Sampling samplingAt(const surface::Surface& surface, const Vec3d& place) {
    constexpr std::size_t around = 5;
    std::vector<tree::Neighbour> near;
    surface.tree().nearest(base::cast<float>(place), around, near);
    std::vector<float> spacings, supports;
    for (const tree::Neighbour& each : near) {
        spacings.push_back(process::spacingAround(surface.tree(), each.block->position(each.slot)));
        supports.push_back(each.block->support(each.slot));
    }
    std::sort(spacings.begin(), spacings.end());
    std::sort(supports.begin(), supports.end());
    return {static_cast<double>(spacings[spacings.size() / 2]), static_cast<double>(supports[supports.size() / 2])};
}

static void measure(const surface::Surface& surface, LoopPoint& at, double behind) {
    Sampling found = samplingAt(surface, at.position);
    if (behind > 0)
        found = samplingAt(surface, at.position - at.outward * (behind * found.spacing));
    at.spacing = found.spacing;
    at.support = found.support;
    if (!(at.spacing > 0))
        at.spacing = at.support * surface::spacingOfUnit;
}

/// Spacings as they are within a few along the curve: where points were drawn by chance single ones vary by half of
/// themselves, and what is made of them would come out too dense, as the smaller ones ask for more.
static void evenOut(std::vector<LoopPoint>& curve) {
    constexpr double reach = 4; // spacings
    const std::size_t n = curve.size();
    std::vector<double> before(n);
    for (std::size_t i = 0; i < n; ++i)
        before[i] = curve[i].spacing;
    for (std::size_t i = 0; i < n; ++i) {
        double sum = before[i], weight = 1;
        for (const std::size_t step : {std::size_t(1), n - 1})
            for (std::size_t k = 1, at = (i + step) % n; k < n / 2; ++k, at = (at + step) % n) {
                const double way = distance(curve[at].position, curve[i].position) / (reach * before[i]);
                if (way >= 1)
                    break;
                sum += (1 - way) * before[at], weight += 1 - way;
            }
        curve[i].spacing = sum / weight;
    }
}

Loop evenLoop(const surface::Surface& surface, const surface::BoundaryCurve& curve, double coarser, double behind) {
    std::vector<LoopPoint> all(curve.points.size());
    double along = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const surface::BoundaryPoint& p = curve.points[i];
        all[i] = {p.position, p.normal, p.outward, 0, 0, false};
        along += dot(p.tangent(), curve.points[(i + 1) % all.size()].position - p.position);
    }
    if (along > 0) // the surface is to the left of its tangents
        std::reverse(all.begin(), all.end());
    base::parallelFor(all.size(), 16, [&](std::size_t i) { measure(surface, all[i], behind); });
    evenOut(all);

    // in units of the spacing, so that steps follow it
    std::vector<double> at(all.size() + 1, 0);
    Loop out;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const LoopPoint &a = all[i], &b = all[(i + 1) % all.size()];
        const double step = distance(a.position, b.position);
        out.length += step;
        at[i + 1] = at[i] + step / (0.5 * (a.spacing + b.spacing));
    }
    const auto count = static_cast<std::size_t>(std::max(6.0, std::round(at.back() / coarser)));
    for (std::size_t k = 0, i = 0; k < count; ++k) {
        const double wanted = at.back() * static_cast<double>(k) / static_cast<double>(count);
        while (i + 1 < all.size() && at[i + 1] <= wanted)
            ++i;
        const double t = at[i + 1] > at[i] ? (wanted - at[i]) / (at[i + 1] - at[i]) : 0;
        const LoopPoint &a = all[i], &b = all[(i + 1) % all.size()];
        out.points.push_back({a.position + (b.position - a.position) * t,
                              normalized(a.normal * (1 - t) + b.normal * t, a.normal),
                              normalized(a.outward * (1 - t) + b.outward * t, a.outward),
                              a.spacing + (b.spacing - a.spacing) * t, a.support + (b.support - a.support) * t, false});
        out.middle += out.points.back().position / static_cast<double>(count);
    }
    return out;
}

double pastEdge(float limit) {
    // o = .2122 + .6226 x + .332 x^2 h (within .002 from -.15 to .2)
    constexpr double atEdge = 0.2122, slope = 0.6226, bend = 0.332;
    const double past = std::clamp(static_cast<double>(limit), 0.1, 0.4) - atEdge;
    return (std::sqrt(slope * slope + 4 * bend * past) - slope) / (2 * bend);
}

Loop edgeOf(const surface::Surface& surface, const Loop& loop) {
    const double beyond = pastEdge(surface.definition().boundaryLimit);
    Loop out = loop;
    base::parallelFor(out.size(), 4, [&](std::size_t i) {
        LoopPoint& p = out.points[i];
        const double by = beyond * p.support;
        const Vec3d place = p.position - p.outward * by;
        const auto foot =
            surface::projectReference(surface, place, {.checkBoundary = false}, {base::cast<float>(p.normal)});
        p.position = foot.ok() && distance(foot.foot, place) < std::abs(by) ? foot.foot : place;
    });
    return out;
}

PlaceOnLoop placeOnLoop(std::span<const double> ways, double way) {
    way -= std::floor(way / ways.back()) * ways.back();
    const auto next = std::upper_bound(ways.begin() + 1, ways.end() - 1, way);
    const auto i = static_cast<std::size_t>(next - ways.begin()) - 1;
    return {i, ways[i + 1] > ways[i] ? (way - ways[i]) / (ways[i + 1] - ways[i]) : 0};
}

void straighten(Loop& loop, std::size_t reach) {
    constexpr double most = 0.5; // spacings
    std::vector<Vec3d> places;
    for (const LoopPoint& p : loop.points)
        places.push_back(p.position);
    const std::vector<Vec3d> means = meansAlong(places, reach);
    std::vector<Vec3d> rest = places;
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] -= means[i];
    rest = meansAlong(rest, reach); // what means take of the curve itself, given back
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const Vec3d by = means[i] + rest[i] - places[i];
        loop.points[i].position += by * std::min(1.0, most * loop.points[i].spacing / std::max(length(by), 1e-300));
    }
}

std::vector<std::uint8_t> touching(const std::vector<Loop>& loops) {
    constexpr double near = 0.5, apart = 3; // in spacings: of places, and along the loop
    struct Place {
        std::uint32_t loop, point;
    };
    std::vector<Place> places;
    std::vector<process::PointGrid::Entry> entries;
    base::Box3d box;
    double widest = 0;
    for (std::uint32_t l = 0; l < loops.size(); ++l)
        for (std::uint32_t i = 0; i < loops[l].size(); ++i) {
            const LoopPoint& p = loops[l].points[i];
            entries.push_back({base::cast<float>(p.position), static_cast<std::uint32_t>(places.size())});
            places.push_back({l, i});
            box.extend(p.position);
            widest = std::max(widest, near * p.spacing);
        }
    std::vector<std::uint8_t> out(loops.size(), 0);
    if (places.empty())
        return out;
    const double cell = std::max({widest, 1e-5 * box.diagonal(), 1e-30});
    process::PointGrid grid(base::cast<float>(box.lo), static_cast<float>(cell));
    grid.build(entries);
    for (std::uint32_t number = 0; number < places.size(); ++number) {
        const Place here = places[number];
        const Loop& loop = loops[here.loop];
        const LoopPoint& p = loop.points[here.point];
        base::CancelScope::check();
        grid.forNear(base::cast<float>(p.position), static_cast<float>(near * p.spacing), [&](const auto& entry) {
            const Place there = places[entry.index];
            const LoopPoint& q = loops[there.loop].points[there.point];
            if (distance(p.position, q.position) >= near * std::min(p.spacing, q.spacing))
                return;
            const auto between =
                static_cast<double>(here.point > there.point ? here.point - there.point : there.point - here.point);
            const bool beside =
                here.loop == there.loop && std::min(between, static_cast<double>(loop.size()) - between) < apart;
            if (!beside)
                out[here.loop] = out[there.loop] = 1;
        });
    }
    return out;
}

} // namespace solid
