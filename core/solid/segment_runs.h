// Pieces of a line in boxes of sixteen, so that where the nearest is asked for few of a long line are looked at.
// Immutable; any number of threads may ask.
#pragma once

#include "core/base/box.h"

#include <span>
#include <vector>

namespace solid {

class SegmentRuns {
  public:
    /// Of each piece the box, in the order of the line.
    explicit SegmentRuns(std::span<const base::Box3d> pieces);

    /// The piece nearest to x, of several the first. `distanceSq` of a piece's number: to x, at least as far as its
    /// box. REQUIRES: there are pieces.
    template <class DistanceSq>
    std::size_t nearest(const base::Vec3d& x, const DistanceSq& distanceSq) const {
        double least = std::numeric_limits<double>::infinity();
        std::size_t out = 0;
        for (std::size_t run = 0; run < m_runs.size(); ++run) {
            if (m_runs[run].distanceSq(x) >= least)
                continue;
            for (std::size_t k = run * together; k < std::min((run + 1) * together, m_count); ++k)
                if (const double sq = distanceSq(k); sq < least)
                    least = sq, out = k;
        }
        return out;
    }

  private:
    static constexpr std::size_t together = 16;
    std::size_t m_count;
    std::vector<base::Box3d> m_runs;
};

} // namespace solid
