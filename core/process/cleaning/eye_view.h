// What a scanner saw, by the directions in which it saw it: neighbours side by side for the scanner, whatever their
// depth. In the plane across a line of sight, with the inverse of depth as height, planes of space are planes again.
// Inside this room.
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

/// A neighbour as seen from a point: beside its line of sight, in a plane at distance 1 from the eye; and the inverse
/// of its depth, 1 as far as the point, more where it is nearer.
struct Sight {
    double u, v, w;
};

class EyeView {
  public:
    /// Of the points whose numbers are told; those in the eye itself are left out. Does not refer to the list.
    EyeView(const surfel::SurfelList& points, std::vector<std::uint32_t> numbers, const base::Vec3d& eye,
            const base::Progress& progress);

    /// The distinct directions, unit vectors.
    const Cloud& directions() const { return m_directions; }
    /// The points seen in one direction, in the order of the list: more than one where beams came back twice.
    std::span<const std::uint32_t> seen(std::size_t direction) const {
        return {m_seen.data() + m_begin[direction], m_begin[direction + 1] - m_begin[direction]};
    }
    std::uint32_t numberOf(std::uint32_t seen) const { return m_numbers[seen]; }
    /// The neighbours of one as it sees them, of each direction the first; without what is behind the eye.
    void sights(std::uint32_t seen, const Neighbours& near, std::vector<Sight>& out) const;

  private:
    std::vector<surfel::Surfel> look(const surfel::SurfelList& points, const base::Vec3d& eye);

    std::vector<std::uint32_t> m_numbers; ///< of the points that are seen
    std::vector<base::Vec3d> m_ways;      ///< from the eye to each of them
    Cloud m_directions;
    std::vector<std::uint32_t> m_begin, m_seen; ///< of each direction
};

} // namespace process
