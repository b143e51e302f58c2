#include "core/base/cancel_scope.h"
#include "core/process/resampling/resample_land.h"
#include "core/process/resampling/resample_set.h"

namespace process {

/// Open borders stay where they are, so their surfels go only beside others of the border.
static bool onBorder(const SampleSet& set, std::uint32_t i) {
    const surface::Evaluationf e = set.frozen.evaluate(set.position[i], surface::Need::Value, {set.normal[i]});
    return e.ok() && e.offCentre > set.pinned * e.unit;
}

/// Of a pair the one that goes, by preference the later; -1 if none may.
static std::int64_t victim(const SampleSet& set, const ClosePair& pair) {
    const bool a = set.free(pair.a), b = set.free(pair.b);
    if (!a || !b)
        return a ? pair.a : b ? pair.b : -1;
    return onBorder(set, pair.b) && !onBorder(set, pair.a) ? pair.a : pair.b;
}

static void remove(SampleSet& set, std::size_t i) {
    set.mark(i, Gone);
    set.scanAround(i, (fillReach + closeDistance) * set.target[i]);
}

void dropStrays(SampleSet& set, const std::vector<std::uint32_t>& strays) {
    for (const std::uint32_t i : strays)
        remove(set, i);
}

void merge(SampleSet& set, const std::vector<ClosePair>& pairs, float distance) {
    const float limitSq = distance * distance;
    for (const ClosePair& pair : pairs) {
        base::CancelScope::check();
        if (pair.distanceSq >= limitSq)
            break;
        if (set.is(pair.a, Gone) || set.is(pair.b, Gone))
            continue;
        const std::int64_t gone = victim(set, pair);
        if (gone >= 0)
            remove(set, static_cast<std::size_t>(gone));
    }
}

} // namespace process
