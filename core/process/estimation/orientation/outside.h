// Which of the two sides of points that agree among themselves is the outer one (process/README 2.3).
#pragma once

#include "core/tree/surfel_tree.h"

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace process {

/// A cloud as its components lie in it. Holds references; any thread may ask.
class Outside {
  public:
    explicit Outside(std::span<const base::Vec3f> positions) : m_positions(positions) {}

    /// How many of 48 directions' outermost points look outwards, from -1, none, to 1.
    double vote(std::span<const base::Vec3f> normals, std::span<const std::uint32_t> members) const;
    /// From which on the vote decides, either way: a plate has 0, a crater -0.15, a cap of 30 degrees 0.4.
    static constexpr double clear = 1 / 3.0;

    /// Do the normals of a component point inwards, where so many voted that they do not? REQUIRES: members, whose
    /// normals agree.
    bool inward(std::span<const base::Vec3f> normals, std::span<const std::uint32_t> members, double votes) const;

  private:
    struct Extent {
        base::Vec3d centre;
        double radius = 0; ///< root mean square of the distances from the centre
    };
    const Extent& extent() const;

    std::span<const base::Vec3f> m_positions;
    mutable std::once_flag m_once;
    mutable Extent m_extent; ///< of all positions, once somebody has asked
};

/// Do the outermost surfels of a model clearly look inwards? Where nothing is open, they are those of a body that is
/// inside out. From up to 65,536 surfels.
bool looksInwards(const tree::SurfelTree& tree);

} // namespace process
