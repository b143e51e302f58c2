// Where on a ray the surface may be: the union of the balls of radius surfaceReach * h about the surfels
// (surface/README 4.1), front to back. Internal to the room.
#pragma once

#include "core/surface/rays/disc_kernel.h"
#include "core/surface/surface.h"

#include <algorithm>

namespace surface {

struct SurfaceInterval {
    double begin = 0, end = 0;
    double unit = 0; ///< the least h of clusters in it

    bool touches(const SurfaceInterval& o) const { return begin <= o.end && o.begin <= end; }
};

/// Disjoint intervals by ascending begin; what touches becomes one.
class IntervalUnion {
  public:
    void add(SurfaceInterval next) {
        auto at = m_intervals.begin();
        while (at != m_intervals.end() && at->end < next.begin)
            ++at;
        while (at != m_intervals.end() && at->touches(next)) {
            next = {std::min(at->begin, next.begin), std::max(at->end, next.end), std::min(at->unit, next.unit)};
            at = m_intervals.erase(at);
        }
        m_intervals.insert(at, next);
    }
    bool empty() const { return m_intervals.empty(); }
    const SurfaceInterval& front() const { return m_intervals.front(); }
    void pop() { m_intervals.erase(m_intervals.begin()); }

  private:
    std::vector<SurfaceInterval> m_intervals; ///< few
};

/// Calls fn(interval) for those within [tMin, tMax], front to back, until it returns false.
template <class Fn>
void forSurfaceIntervals(const Surface& surface, const base::Rayf& ray, double tMin, double tMax, const Fn& fn) {
    constexpr double rounding = 1e-6; // of t: chords are float
    const Weight weight = surface.definition().weight;
    IntervalUnion open;
    bool on = true;
    surface.tree().alongRay(ray, [&](const surfel::SurfelBlock& block, int cluster, float enter, float) {
        // nothing unseen begins before `enter`
        while (on && !open.empty() && open.front().end < double(enter)) {
            on = fn(open.front());
            open.pop();
        }
        if (!on || double(enter) > tMax)
            return false;
        if (const auto chord = reachChord(block.channel(cluster, surfel::X), ray)) {
            const double begin = std::max(double(chord->first) * (1 - rounding), tMin);
            const double end = std::min(double(chord->second) * (1 + rounding), tMax);
            if (begin <= end)
                open.add({begin, end, double(unitOf(weight, block.bounds(cluster).maxSupport))});
        }
        return true;
    });
    for (; on && !open.empty(); open.pop())
        on = fn(open.front());
}

} // namespace surface
