// The moving set of one resampling: the touched surfels, what stands around them, and what is born. Internal to
// resample.
//
// Samples are numbered: those of the version by (block, slot), then the new ones in the order of their acceptance. The
// number is the tie breaker everywhere.
#pragma once

#include "core/process/resampling/point_grid.h"
#include "core/process/resampling/resample.h"

#include <algorithm>

namespace process {

/// Do two normals belong to one sheet? By the layout: signed, unsigned, or no normals and every pair passes.
class Facing {
  public:
    static constexpr float leastCosine = 0.17f;

    explicit Facing(const surfel::AttributeLayout& layout) : m_known(layout.normals), m_oriented(layout.oriented) {}
    bool same(const base::Vec3f& a, const base::Vec3f& b) const {
        const float c = dot(a, b);
        return !m_known || (m_oriented ? c : std::abs(c)) > leastCosine;
    }
    bool known() const { return m_known; }
    bool oriented() const { return m_oriented; }

  private:
    bool m_known, m_oriented;
};

/// What a sample is and what happened to it.
enum SampleFlag : std::uint8_t {
    Gone = 1,    ///< merged away
    Touched = 2, ///< one of those to be resampled, or new; others are only in the way
    Masked = 4,  ///< stays as it is
    New = 8,     ///< born here
    Awake = 16,  ///< takes part in relaxation
    Moved = 32,  ///< does not lie where it lay
    Scan = 64,   ///< is looked at in the next scan
    Full = 128,  ///< what room is beside it was there before: none grows there
};

/// The mean of two targets counts as at most so many of the smaller: fine detail does not give way beside a coarse
/// sampling.
constexpr float unlike = 1.25f;

/// A place that may have room: direction `k` of eight around sample `from`.
struct Gap {
    std::uint32_t from;
    std::uint32_t k;
    base::Vec3f place;
};

struct SampleSet {
    const surface::Surface& version;
    const surface::Surface& frozen;
    ResampleOptions options;
    float spacing;
    Facing facing;
    /// Off-centre values in units of h from which a place belongs to an open border, and at which nothing grows; the
    /// last where the surface goes on (ResampleOptions::goesOn), or between others where a stroke drew them apart.
    float pinned, grown, grownOn;

    std::vector<base::Vec3f> position, normal;
    std::vector<float> target; ///< of each its own target spacing; `spacing` is the largest
    std::vector<std::uint8_t> flags;
    std::vector<std::uint8_t> refused; ///< by bits, in which directions the frozen surface had no place for another

    /// Of the samples that the version has: where they come from.
    struct Source {
        std::uint32_t block;
        std::uint8_t slot;
    };
    std::vector<Source> source;
    std::vector<std::uint32_t> blockNumber; ///< by Source::block
    std::vector<surfel::BlockPtr> block;
    PointGrid grid; ///< of the samples that are not gone

    /// Where an awake sample of the version lay on the frozen surface (g_i of step 0); unset for others.
    std::vector<base::Vec3f> oldGradient;

    /// Of the touched, those near restless ones (all where all are to relax): nothing happens to others.
    SampleSet(const surface::Surface& version, const tree::Selection& touched, const tree::Selection& restless,
              const ResampleOptions& options, const surface::Surface& frozen);
    std::size_t size() const { return position.size(); }
    std::size_t oldCount() const { return source.size(); }
    bool is(std::size_t i, unsigned flag) const { return (flags[i] & flag) != 0; }
    void mark(std::size_t i, unsigned flag) { flags[i] = static_cast<std::uint8_t>(flags[i] | flag); }
    void unmark(std::size_t i, unsigned flag) { flags[i] = static_cast<std::uint8_t>(flags[i] & ~flag); }
    /// May it move or vanish?
    bool free(std::size_t i) const { return is(i, Touched) && !is(i, Masked); }

    float targetAt(const base::Vec3f& x) const {
        return options.field ? std::min(spacing, options.field->at(x)) : spacing;
    }
    /// Of two samples what their distance is measured in: the mean, unless one is far coarser.
    float between(std::size_t i, std::size_t j) const {
        const float a = target[i], b = target[j];
        return std::min(0.5f * (a + b), unlike * std::min(a, b));
    }
    void refuse(const Gap& gap) { refused[gap.from] = static_cast<std::uint8_t>(refused[gap.from] | 1u << gap.k); }
    bool hasRefused(const Gap& gap) const { return (refused[gap.from] >> gap.k & 1) != 0; }
    std::uint32_t bear(const base::Vec3f& place, const base::Vec3f& direction, std::uint32_t from);
    void rebuildGrid();
    /// Marks Scan on the touched within `radius` of a sample.
    void scanAround(std::size_t i, float radius);
    /// The same around all that moved, in parallel; `reach` in units of their targets.
    void scanNearMoved(float reach);

  private:
    float targetBeside(const base::Vec3f& place, std::uint32_t from) const;
    void collect(const tree::Selection& touched, const tree::Selection& restless);
};

/// Off-centre values from which a place belongs to an open border, in units of h.
float pinnedAt(surface::Weight weight);

// --- distances of the scheme, in spacings ---
constexpr float mergeDistance = 0.60f; ///< closer pairs lose one, but for ResampleOptions::merge at the beginning
constexpr float closeDistance = 0.70f; ///< closer pairs wake their surroundings
constexpr float fillDistance = 1.05f;  ///< where a surfel looks for room
constexpr float fillClear = 0.675f;    ///< room: nothing so near
constexpr float fillApart = 0.75f;     ///< and nothing so near the place on the surface
constexpr float fillStray = 1.20f;     ///< farthest that place may lie from where it was looked for
constexpr float wakeDistance = 1.60f;
constexpr float relaxDistance = 1.50f; ///< repulsion ends here
constexpr float relaxRate = 0.20f;
constexpr float relaxStep = 0.30f;   ///< longest step of a sweep
constexpr float heightLimit = 0.25f; ///< largest height of a sample over the surface that is kept
constexpr float fillReach = fillDistance + fillClear;
/// Farthest that a resampling acts from a restless surfel: a new one, what it wakes, and what finds room beside that.
constexpr float farReach = 2 * (fillDistance + fillStray) + wakeDistance + fillReach + 3 * relaxStep;

/// Is it the crumb of a fold: hardly any of its own sheet within fillReach of it, and many that face elsewhere? Nothing
/// that so few bear can be called a surface. (Beside the corner of a box stand about 2 of its own and 5 others; on a
/// plate one spacing thick, half and half.)
constexpr bool isStray(int alike, int others) {
    return others >= 8 && others >= 3 * alike;
}

// --- the steps, in their order ---

/// Of the touched, those that have something too near or room beside them, or nearly so: worth a scan. In parallel.
tree::Selection restlessOf(const surface::Surface& version, const tree::Selection& touched,
                           const ResampleOptions& options);
/// Pairs so close are looked at, in spacings.
inline float lookedAt(const ResampleOptions& options) {
    return std::max(closeDistance, options.merge);
}

struct ClosePair {
    float distanceSq;   ///< in units of SampleSet::between
    std::uint32_t a, b; ///< a < b
};
struct ScanResult {
    std::vector<std::uint32_t> strays; ///< free samples that no sheet bears; ascending
    std::vector<ClosePair> pairs;      ///< closer than lookedAt, at least one free; ascending (distance, a, b)
    std::vector<Gap> gaps;             ///< ascending (from, k)
};
/// Looks at all samples marked Scan, and unmarks them. In parallel.
ScanResult scan(SampleSet& set);

/// Removes samples that no sheet bears. Marks Scan around what went.
void dropStrays(SampleSet& set, const std::vector<std::uint32_t>& strays);
/// Removes one of every pair closer than `distance` spacings, closest first. Marks Scan around what went.
void merge(SampleSet& set, const std::vector<ClosePair>& pairs, float distance);
/// Adds samples in gaps. Returns the number of the first.
std::size_t fill(SampleSet& set, std::vector<Gap> gaps);
/// Wakes what is near new samples (from `firstNew` on) and close pairs.
void wake(SampleSet& set, const std::vector<ClosePair>& pairs, std::size_t firstNew);
void relax(SampleSet& set);
/// Puts what moved or is new exactly in place, fits it where that is asked for, and writes the edit.
tree::Edit settle(SampleSet& set);

} // namespace process
