#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/resampling/near_samples.h"
#include "core/process/resampling/repulsion.h"
#include "core/process/resampling/resample_land.h"
#include "core/process/resampling/resample_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace process {

/// A square that is larger by this has a larger root.
constexpr float rounding = 1.0001f;
/// A displacement shorter than this part of the spacing is taken back: not worth a changed surfel. What is pushed by
/// less is at rest, and need not be asked where the surface is.
constexpr float notice = 0.01f;
/// Where all are to relax, what is pushed by less than this is at rest: most of what has been relaxed before. (By .05
/// pairs that are .62 spacings apart may stay so.)
constexpr float restAll = 0.03f;

static void wakeAround(SampleSet& set, std::size_t i) {
    base::CancelScope::check();
    const float radius = wakeDistance * set.target[i];
    set.grid.forNear(set.position[i], radius, [&](const PointGrid::Entry& e) {
        if (set.free(e.index) && !set.is(e.index, Gone) &&
            distanceSq(set.position[e.index], set.position[i]) < radius * radius)
            set.mark(e.index, Awake);
    });
}

void wake(SampleSet& set, const std::vector<ClosePair>& pairs, std::size_t firstNew) {
    if (set.options.relaxAll) {
        for (std::size_t i = 0; i < set.size(); ++i)
            if (set.free(i) && !set.is(i, Gone))
                set.mark(i, Awake);
        return;
    }
    for (const ClosePair& pair : pairs)
        if (!set.is(pair.a, Gone) && !set.is(pair.b, Gone))
            wakeAround(set, pair.a), wakeAround(set, pair.b);
    for (std::size_t i = firstNew; i < set.size(); ++i)
        wakeAround(set, i);
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
            NearSamples near(set);
            for (std::size_t k = begin; k < end; ++k) {
                const std::size_t before = found[chunk].size();
                const std::uint32_t i = awake[k];
                const float reach = spacings * set.target[i];
                if (!near.covers(set.position[i], reach))
                    near.gather(std::span(awake).subspan(k, end - k), spacings);
                near.forWithin(set.position[i], reach, [&](std::uint32_t j, const base::Vec3f& n) {
                    if (j != i && set.facing.same(set.normal[i], n))
                        found[chunk].push_back(j);
                });
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
};

/// d = sum 0.2 (1.5 s - l) t / |t| over the neighbours on the same sheet, t the tangential part of p_i - p_j.
base::Vec3f repulsion(const SampleSet& set, std::uint32_t i, std::span<const std::uint32_t> neighbours,
                      Repulsion& sum) {
    const base::Vec3f p = set.position[i];
    const bool even = !set.options.field && !set.options.targetOf;
    const float own = relaxDistance * set.target[i];
    sum.begin(set.normal[i]);
    for (const std::uint32_t j : neighbours) {
        const base::Vec3f d = p - set.position[j];
        const float reach = even ? own : relaxDistance * set.between(i, j);
        if (dot(d, d) <= rounding * reach * reach) // few: the roots of others are not asked for
            sum.add(d, reach);
    }
    const base::Vec3f all = sum.end() * relaxRate;
    const float most = relaxStep * set.target[i], l = length(all);
    return l > most ? all * (most / l) : all;
}

/// Those that take part in relaxation, and whom each of them sees.
struct Relaxing {
    SampleSet& set;
    std::vector<std::uint32_t> awake;
    Neighbours neighbours;
    std::vector<std::size_t> rank; ///< of each of the awake among those that `neighbours` was made for
    std::vector<base::Vec3f> push; ///< of each, now

    explicit Relaxing(SampleSet& of) : set(of), awake(marked(of)), neighbours(of, awake), rank(awake.size()) {
        std::iota(rank.begin(), rank.end(), std::size_t(0));
        measure();
    }
    void measure() {
        push.resize(awake.size());
        base::parallelChunks(awake.size(), Neighbours::grain, [&](std::size_t begin, std::size_t end, std::size_t) {
            Repulsion sum;
            for (std::size_t k = begin; k < end; ++k)
                push[k] = repulsion(set, awake[k], neighbours.of(rank[k]), sum);
        });
    }
    /// Leaves those of which keeps(k) is true.
    template <class Keeps>
    void keep(const Keeps& keeps) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < awake.size(); ++k)
            if (keeps(k))
                awake[kept] = awake[k], rank[kept] = rank[k], push[kept++] = push[k];
        awake.resize(kept), rank.resize(kept), push.resize(kept);
    }
    /// Where they are, moved by `share` of the push.
    std::vector<base::Vec3f> places(float share) const {
        std::vector<base::Vec3f> out(awake.size());
        for (std::size_t k = 0; k < awake.size(); ++k)
            out[k] = set.position[awake[k]] + push[k] * share;
        return out;
    }

  private:
    static std::vector<std::uint32_t> marked(SampleSet& of) {
        std::vector<std::uint32_t> out;
        for (std::uint32_t i = 0; i < of.size(); ++i)
            if (of.is(i, Awake)) {
                of.unmark(i, Awake);
                if (!of.is(i, Gone))
                    out.push_back(i);
            }
        return out;
    }
};

void dropResting(Relaxing& those) {
    const float rest = those.set.options.relaxAll ? restAll : notice;
    those.keep([&](std::size_t k) {
        const float least = rest * those.set.target[those.awake[k]];
        return dot(those.push[k], those.push[k]) > least * least;
    });
}

std::vector<base::Vec3f> sidesOf(const Relaxing& those) {
    std::vector<base::Vec3f> out(those.awake.size());
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = those.set.normal[those.awake[k]];
    return out;
}

/// Notes where they lie on the frozen surface (step 0, for those that need it); border surfels stay put.
void pin(Relaxing& those) {
    SampleSet& set = those.set;
    const std::vector<base::Vec3f> places = those.places(0);
    std::vector<surface::TogetherAt> at(places.size());
    surface::evaluateTogether(set.frozen, places, sidesOf(those), at);
    std::vector<std::uint8_t> free(places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::uint32_t i = those.awake[k];
        const base::Vec3f g = normalized(at[k].gradient);
        free[k] = at[k].ok() && g != base::Vec3f{} && at[k].offCentre <= set.pinned * at[k].unit ? 1 : 0;
        if (i < set.oldCount())
            set.oldGradient[i] = g;
    }
    those.keep([&](std::size_t k) { return free[k] != 0; });
}

/// One sweep of Jacobi's kind: all of the awake from where they are to where they are pushed.
void sweepOnce(Relaxing& those) {
    SampleSet& set = those.set;
    const std::vector<base::Vec3f> target = those.places(1);
    const std::vector<Landing> landings = landTogether(set.frozen, target, sidesOf(those), 1, 0);
    std::vector<base::Vec3f> next(target.size());
    for (std::size_t k = 0; k < next.size(); ++k) {
        const std::uint32_t i = those.awake[k];
        const Landing& y = landings[k];
        const bool kept = y.ok && y.at.offCentre <= set.grown * y.at.unit && set.facing.same(set.normal[i], y.gradient);
        next[k] = kept ? y.place : set.position[i];
    }
    for (std::size_t k = 0; k < next.size(); ++k)
        set.position[those.awake[k]] = next[k];
}

} // namespace

void relax(SampleSet& set) {
    Relaxing those(set);
    dropResting(those);
    pin(those);
    const std::vector<base::Vec3f> start = those.places(0);
    for (int sweep = 0; sweep < set.options.sweeps; ++sweep) {
        if (sweep > 0)
            those.measure();
        sweepOnce(those);
    }
    for (std::size_t k = 0; k < start.size(); ++k) {
        const std::uint32_t i = those.awake[k];
        const float least = notice * set.target[i];
        if (distanceSq(set.position[i], start[k]) > least * least)
            set.mark(i, Moved), set.refused[i] = 0;
        else if (!set.is(i, New))
            set.position[i] = start[k];
    }
}

} // namespace process
