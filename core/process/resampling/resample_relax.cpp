#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/resampling/resample_land.h"
#include "core/process/resampling/resample_set.h"
#include "core/surface/evaluation/packets.h"

#include <algorithm>
#include <cmath>

namespace process {

/// A displacement shorter than this part of the spacing is taken back: not worth a changed surfel.
constexpr float notice = 0.01f;

static void wakeAround(SampleSet& set, std::size_t i) {
    base::CancelScope::check();
    const float radius = wakeDistance * set.target[i];
    set.grid.forNear(set.position[i], radius, [&](const PointGrid::Entry& e) {
        if (set.free(e.index) && !set.is(e.index, Gone) &&
            distanceSq(set.position[e.index], set.position[i]) < radius * radius)
            set.mark(e.index, Awake);
    });
}

static std::vector<base::Vec3f> positionsOf(const SampleSet& set, const std::vector<std::uint32_t>& which) {
    std::vector<base::Vec3f> out(which.size());
    for (std::size_t k = 0; k < which.size(); ++k)
        out[k] = set.position[which[k]];
    return out;
}

/// Where the awake lie on the frozen surface (step 0, for those that need it); border surfels stay put.
static void pin(SampleSet& set) {
    std::vector<std::uint32_t> awake;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        if (set.is(i, Awake))
            awake.push_back(i);
    const std::vector<base::Vec3f> places = positionsOf(set, awake);
    surface::forPackets(set.frozen, places, 0, [&](surface::Source& source, std::size_t k) {
        const std::uint32_t i = awake[k];
        const surface::Evaluationf e = source.evaluate(places[k], surface::Need::Gradient, {set.normal[i]});
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

namespace {

/// Who may repel each of the awake in any of the sweeps: those of its sheet that are near enough now.
struct Neighbours {
    std::vector<std::size_t> first; ///< of each, and the end
    std::vector<std::uint32_t> all;

    Neighbours(const SampleSet& set, const std::vector<std::uint32_t>& awake) {
        // Neighbours' targets are little larger.
        const float spread = set.options.targetOf ? unlike : set.options.field ? 1 + grading : 1.0f;
        const float spacings = (relaxDistance + 2 * relaxStep * static_cast<float>(set.options.sweeps - 1)) * spread;
        std::vector<std::vector<std::uint32_t>> found(base::chunkCount(awake.size(), grain));
        std::vector<std::size_t> counts(awake.size());
        base::parallelChunks(awake.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t before = found[chunk].size();
                look(set, awake[k], spacings * set.target[awake[k]], found[chunk]);
                counts[k] = found[chunk].size() - before;
            }
        });
        first.assign(1, 0);
        for (const std::size_t count : counts)
            first.push_back(first.back() + count);
        all.reserve(first.back());
        for (const auto& part : found)
            all.insert(all.end(), part.begin(), part.end());
    }
    std::span<const std::uint32_t> of(std::size_t k) const {
        return {all.data() + first[k], all.data() + first[k + 1]};
    }

    static constexpr std::size_t grain = 64;

  private:
    static void look(const SampleSet& set, std::uint32_t i, float reach, std::vector<std::uint32_t>& out) {
        set.grid.forNear(set.position[i], reach, [&](const PointGrid::Entry& e) {
            if (e.index != i && !set.is(e.index, Gone) && distanceSq(e.position, set.position[i]) < reach * reach &&
                set.facing.same(set.normal[i], set.normal[e.index]))
                out.push_back(e.index);
        });
    }
};

/// d = sum 0.2 (1.5 s - l) t / |t| over the neighbours on the same sheet, t the tangential part of p_i - p_j.
base::Vec3f repulsion(const SampleSet& set, std::uint32_t i, std::span<const std::uint32_t> neighbours) {
    const base::Vec3f p = set.position[i], n = set.normal[i];
    base::Vec3f sum;
    for (const std::uint32_t j : neighbours) {
        const base::Vec3f d = p - set.position[j];
        const float l = length(d), reach = relaxDistance * set.between(i, j);
        if (l < reach)
            sum += normalized(d - n * dot(n, d)) * (relaxRate * (reach - l));
    }
    const float most = relaxStep * set.target[i], l = length(sum);
    return l > most ? sum * (most / l) : sum;
}

/// One sweep of Jacobi's kind: all of the awake from where they are to where they are pushed.
void sweepOnce(SampleSet& set, const std::vector<std::uint32_t>& awake, const Neighbours& neighbours) {
    std::vector<base::Vec3f> target(awake.size()), next(awake.size());
    base::parallelFor(awake.size(), Neighbours::grain, [&](std::size_t k) {
        target[k] = set.position[awake[k]] + repulsion(set, awake[k], neighbours.of(k));
    });
    surface::forPackets(set.frozen, target, 0, [&](surface::Source& source, std::size_t k) {
        const std::uint32_t i = awake[k];
        const Landing y = land(source, target[k], set.normal[i], 1, 0);
        const bool kept = y.ok && y.at.offCentre <= set.grown * y.at.unit && set.facing.same(set.normal[i], y.gradient);
        next[k] = kept ? y.place : set.position[i];
    });
    for (std::size_t k = 0; k < awake.size(); ++k)
        set.position[awake[k]] = next[k];
}

} // namespace

void relax(SampleSet& set) {
    std::vector<std::uint32_t> awake;
    for (std::uint32_t i = 0; i < set.size(); ++i)
        if (set.is(i, Awake) && !set.is(i, Gone))
            awake.push_back(i);
    const std::vector<base::Vec3f> start = positionsOf(set, awake);
    const Neighbours neighbours(set, awake);
    for (int sweep = 0; sweep < set.options.sweeps; ++sweep)
        sweepOnce(set, awake, neighbours);
    for (std::size_t k = 0; k < awake.size(); ++k) {
        const float least = notice * set.target[awake[k]];
        set.unmark(awake[k], Awake);
        if (distanceSq(set.position[awake[k]], start[k]) > least * least)
            set.mark(awake[k], Moved), set.refused[awake[k]] = 0;
        else if (!set.is(awake[k], New))
            set.position[awake[k]] = start[k];
    }
}

} // namespace process
