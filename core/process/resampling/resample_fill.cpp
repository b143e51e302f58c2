#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/process/estimation/widest_gap.h"
#include "core/process/resampling/resample_land.h"
#include "core/process/resampling/resample_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace process {

namespace {

/// Landings for a gap are for its place only; settling makes them exact.
constexpr int steps = 6;
constexpr float tolerance = 0.02f; ///< in spacings; a step ends nearer to the surface than by its square
/// Off-centre values along the surface hardly change on the way down: what begins so far beyond the limit ends beyond.
constexpr float hopeless = 1.3f;
/// Sum of the normals over the sum of the weights below which sheets mix: what grows there grows inside out.
constexpr float leastAgreement = 0.5f;
/// Of the two last samples of a rim that is drawn along itself none is farther off than this, in spacings, where
/// there is room between them.
constexpr float betweenReach = 1.8f;
constexpr float freeSector = 3.49f; ///< 200 degrees: with 185 a rim recedes by .04 s where it becomes 1.8 times as long
/// In place of fillApart where only what has moved is looked at: of places chosen by chance, as many are born then as
/// are merged. By fillApart 2 to 4 % more are.
constexpr float wellApart = 0.82f;

/// Nothing may lie so near to where one is born, in spacings.
float apartOf(const SampleSet& set) {
    return set.options.order == Order::RelaxOnly ? wellApart : fillApart;
}

/// Does anything that faces as `n` lie within `radius` of x?
bool occupied(const SampleSet& set, const PointGrid& grid, const base::Vec3f& x, const base::Vec3f& n, float radius) {
    bool found = false;
    grid.forNear(x, radius, [&](const PointGrid::Entry& e) {
        found |= !set.is(e.index, Gone) && distanceSq(e.position, x) < radius * radius &&
                 set.facing.same(n, set.normal[e.index]);
    });
    return found;
}

/// Would a sample there stand alone among others that face elsewhere?
bool stray(const SampleSet& set, const base::Vec3f& x, const base::Vec3f& n, float radius) {
    int alike = 0, others = 0;
    set.grid.forNear(x, radius, [&](const PointGrid::Entry& e) {
        if (!set.is(e.index, Gone) && distanceSq(e.position, x) < radius * radius)
            ++(set.facing.same(n, set.normal[e.index]) ? alike : others);
    });
    return isStray(alike, others);
}

/// Is the place between samples of its sheet: is no side of it, as seen from above, free of them by more than
/// `freeSector`? On the way from one of the last samples of a rim to the next half a turn is free, beyond it more.
bool between(const SampleSet& set, const base::Vec3f& x, const base::Vec3f& n, float radius) {
    const base::Vec3f u = perpendicular(n), v = cross(n, u);
    std::vector<float> at;
    set.grid.forNear(x, radius, [&](const PointGrid::Entry& e) {
        const base::Vec3f d = e.position - x;
        if (!set.is(e.index, Gone) && dot(d, d) < radius * radius && set.facing.same(n, set.normal[e.index]))
            at.push_back(std::atan2(dot(d, v), dot(d, u)));
    });
    return at.size() >= 3 && widestGap(at) < freeSector;
}

/// Do the samples bear the place, or does the surface go on there?
bool borne(const SampleSet& set, const Gap& gap, const Landing& y) {
    if (y.at.offCentre <= set.grown * y.at.unit)
        return true;
    if (!(y.at.offCentre <= set.grownOn * y.at.unit))
        return false;
    if (set.options.goesOn)
        return set.options.goesOn(y.place, y.at.centroid);
    return between(set, y.place, normalized(y.gradient), betweenReach * set.target[gap.from]);
}

bool acceptable(const SampleSet& set, const Gap& gap, const Landing& y) {
    const base::Vec3f n = set.normal[gap.from];
    const float stray = fillStray * set.target[gap.from];
    return y.ok && distanceSq(y.place, gap.place) <= stray * stray && y.at.agreement >= leastAgreement &&
           set.facing.same(n, y.gradient) && borne(set, gap, y);
}

/// Is it clear after a step that nothing will grow there: beyond an open border?
bool beyondBorder(const SampleSet& set, const Landing& y, const base::Vec3f& evaluated) {
    const float down = dot(y.gradient, evaluated - y.at.centroid), limit = hopeless * set.grownOn * y.at.unit;
    return y.at.offCentre * y.at.offCentre - down * down > limit * limit;
}

/// What became of a gap.
enum class Fate : std::uint8_t {
    Falling, ///< not known yet
    Landed,
    Taken,  ///< something stands in the way, or it would be a crumb
    Refused ///< the frozen surface has nothing to offer there
};

/// After a step that was evaluated there: its end, if that is clear. On raw scans nine in ten gaps lie at borders, or
/// beside what stands above them.
Fate fateOf(const SampleSet& set, const Gap& gap, const Landing& y, const base::Vec3f& evaluated, bool stepped) {
    const float target = set.target[gap.from];
    const base::Vec3f n = set.normal[gap.from];
    if (stepped && beyondBorder(set, y, evaluated))
        return Fate::Refused;
    if (stepped && y.step > tolerance * target) {
        const float apart = apartOf(set) * target - y.step;
        return apart > 0 && occupied(set, set.grid, y.place, n, apart) ? Fate::Taken : Fate::Falling;
    }
    if (!acceptable(set, gap, y))
        return Fate::Refused;
    // Two in three on raw scans: samples stand off the surface there, and what is clear of them above it is not on it.
    if (occupied(set, set.grid, y.place, n, apartOf(set) * target))
        return Fate::Taken;
    return stray(set, y.place, y.gradient, fillReach * target) ? Fate::Taken : Fate::Landed;
}

/// Lets them all down onto the frozen surface, step by step.
std::vector<Fate> land(const SampleSet& set, const std::vector<Gap>& gaps, std::vector<Landing>& out) {
    std::vector<Fate> fate(gaps.size(), Fate::Falling);
    std::vector<std::uint32_t> falling(gaps.size());
    std::iota(falling.begin(), falling.end(), 0u);
    out.assign(gaps.size(), {});
    for (std::size_t i = 0; i < gaps.size(); ++i)
        out[i].place = gaps[i].place;
    std::vector<base::Vec3f> places, sides;
    std::vector<surface::TogetherAt> at;
    for (int k = 0; k < steps && !falling.empty(); ++k) {
        places.resize(falling.size()), sides.resize(falling.size()), at.resize(falling.size());
        for (std::size_t i = 0; i < falling.size(); ++i)
            places[i] = out[falling[i]].place, sides[i] = set.normal[gaps[falling[i]].from];
        surface::evaluateTogether(set.frozen, places, sides, at);
        base::parallelFor(falling.size(), 128, [&](std::size_t i) {
            const Gap& gap = gaps[falling[i]];
            Landing& y = out[falling[i]];
            const bool stepped = landStep(set.frozen, gap.place, at[i], y);
            fate[falling[i]] = fateOf(set, gap, y, places[i], stepped);
        });
        std::erase_if(falling, [&](std::uint32_t i) { return fate[i] != Fate::Falling; });
    }
    for (const std::uint32_t i : falling) // as near as they came
        fate[i] = fateOf(set, gaps[i], out[i], {}, false);
    return fate;
}

/// Takes out what something stands in by now, or whose surfel is gone.
void dropClosed(const SampleSet& set, std::vector<Gap>& gaps) {
    std::vector<std::uint8_t> closed(gaps.size());
    base::parallelFor(gaps.size(), 128, [&](std::size_t k) {
        const Gap& gap = gaps[k];
        const float clear = fillClear * set.target[gap.from];
        closed[k] = set.is(gap.from, Gone) || occupied(set, set.grid, gap.place, set.normal[gap.from], clear) ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < gaps.size(); ++k)
        if (!closed[k])
            gaps[kept++] = gaps[k];
    gaps.resize(kept);
}

/// Takes from `gaps`, in order, a largest set of places that are apart: one answer then serves all around it.
std::vector<Gap> takeApart(SampleSet& set, std::vector<Gap>& gaps) {
    std::vector<Gap> taken, left;
    PointGrid places(set.version.tree().bounds().centre(), fillReach * set.spacing);
    for (const Gap& gap : gaps) {
        base::CancelScope::check();
        const float apart = fillClear * set.target[gap.from];
        bool alone = true;
        places.forNear(gap.place, apart, [&](const PointGrid::Entry& e) {
            alone &= distanceSq(e.position, gap.place) >= apart * apart ||
                     !set.facing.same(set.normal[gap.from], set.normal[e.index]);
        });
        if (alone)
            places.insert({gap.place, gap.from}), taken.push_back(gap);
        else
            left.push_back(gap);
    }
    gaps = std::move(left);
    return taken;
}

} // namespace

std::size_t fill(SampleSet& set, std::vector<Gap> gaps) {
    const std::size_t first = set.size();
    while (!gaps.empty()) {
        dropClosed(set, gaps);
        const std::vector<Gap> asked = takeApart(set, gaps);
        std::vector<Landing> found;
        const std::vector<Fate> fate = land(set, asked, found);
        for (std::size_t i = 0; i < asked.size(); ++i) {
            base::CancelScope::check();
            const Gap& gap = asked[i];
            if (fate[i] == Fate::Refused)
                set.refuse(gap);
            const base::Vec3f n = set.normal[gap.from];
            if (fate[i] == Fate::Landed &&
                !occupied(set, set.grid, found[i].place, n, apartOf(set) * set.target[gap.from]))
                set.bear(found[i].place, dot(found[i].gradient, n) < 0 ? -found[i].gradient : found[i].gradient,
                         gap.from);
        }
    }
    return first;
}

} // namespace process
