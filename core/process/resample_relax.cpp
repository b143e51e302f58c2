#include "core/base/parallel.h"
#include "core/process/resample_land.h"
#include "core/process/resample_set.h"

#include <algorithm>
#include <cmath>

namespace process {

/// A displacement shorter than this part of the spacing is taken back: not worth a changed surfel.
constexpr float notice = 0.01f;

static void wakeAround(SampleSet& set, std::size_t i) {
    const float radius = wakeDistance * set.spacing;
    set.grid.forNear(set.position[i], radius, [&](const PointGrid::Entry& e) {
        if (set.free(e.index) && !set.is(e.index, Gone) &&
            distanceSq(set.position[e.index], set.position[i]) < radius * radius)
            set.mark(e.index, Awake);
    });
}

/// Where the awake lie on the frozen surface (step 0, for those that need it); border surfels stay put.
static void pin(SampleSet& set) {
    std::vector<std::uint32_t> awake;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        if (set.is(i, Awake))
            awake.push_back(i);
    base::parallelFor(awake.size(), 32, [&](std::size_t k) {
        const std::uint32_t i = awake[k];
        const surface::Evaluationf e = set.frozen.evaluate(set.position[i], surface::Need::Gradient, {set.normal[i]});
        const base::Vec3f g = normalized(e.gradient);
        if (!e.ok() || g == base::Vec3f{} || e.offCentre > set.pinned * e.unit)
            set.unmark(i, Awake);
        if (i < set.oldCount())
            set.oldGradient[i] = g;
    });
}

void wake(SampleSet& set, const std::vector<ClosePair>& pairs, std::size_t firstNew) {
    for (const ClosePair& pair : pairs)
        if (!set.is(pair.a, Gone) && !set.is(pair.b, Gone))
            wakeAround(set, pair.a), wakeAround(set, pair.b);
    for (std::size_t i = firstNew; i < set.size(); ++i)
        wakeAround(set, i);
    for (std::size_t i = 0; set.options.relaxAll && i < set.size(); ++i)
        if (set.free(i) && !set.is(i, Gone))
            set.mark(i, Awake);
    pin(set);
}

/// d = sum 0.2 (1.5 s - l) t / |t| over the neighbours on the same sheet, t the tangential part of p_i - p_j.
static base::Vec3f repulsion(const SampleSet& set, std::uint32_t i, float slack) {
    const float reach = relaxDistance * set.spacing;
    const base::Vec3f p = set.position[i], n = set.normal[i];
    base::Vec3f sum;
    set.grid.forNear(p, reach + slack, [&](const PointGrid::Entry& e) {
        if (e.index == i || set.is(e.index, Gone) || !set.facing.same(n, set.normal[e.index]))
            return;
        const base::Vec3f d = p - set.position[e.index];
        const float l = length(d);
        if (l >= reach)
            return;
        const base::Vec3f t = d - n * dot(n, d);
        sum += normalized(t) * (relaxRate * (reach - l));
    });
    const float most = relaxStep * set.spacing, l = length(sum);
    return l > most ? sum * (most / l) : sum;
}

void relax(SampleSet& set) {
    std::vector<std::uint32_t> awake;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        if (set.is(i, Awake) && !set.is(i, Gone))
            awake.push_back(i);
    std::vector<base::Vec3f> start(awake.size()), next(awake.size());
    for (std::size_t k = 0; k < awake.size(); ++k)
        start[k] = set.position[awake[k]];
    for (int sweep = 0; sweep < set.options.sweeps; ++sweep) {
        // The grid holds the places before the first sweep.
        const float slack = 1.5f * relaxStep * set.spacing * static_cast<float>(sweep);
        base::parallelFor(awake.size(), 64, [&](std::size_t k) {
            const std::uint32_t i = awake[k];
            const Landing y = land(set.frozen, set.position[i] + repulsion(set, i, slack), set.normal[i], 1, 0);
            const bool kept =
                y.ok && y.at.offCentre <= set.grown * y.at.unit && set.facing.same(set.normal[i], y.gradient);
            next[k] = kept ? y.place : set.position[i];
        });
        for (std::size_t k = 0; k < awake.size(); ++k)
            set.position[awake[k]] = next[k];
    }
    const float least = notice * set.spacing;
    for (std::size_t k = 0; k < awake.size(); ++k) {
        set.unmark(awake[k], Awake);
        if (distanceSq(set.position[awake[k]], start[k]) > least * least)
            set.mark(awake[k], Moved);
        else if (!set.is(awake[k], New))
            set.position[awake[k]] = start[k];
    }
}

} // namespace process
