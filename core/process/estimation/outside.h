// Which of the two sides of points that agree among themselves is the outer one (process/README 2.3).
#pragma once

#include "core/base/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace process {

/// A cloud as its components lie in it. Holds references; any thread may ask.
class Outside {
  public:
    explicit Outside(std::span<const base::Vec3f> positions);

    /// Do the normals of a component point inwards? REQUIRES: members, whose normals agree.
    bool inward(std::span<const base::Vec3f> normals, std::span<const std::uint32_t> members) const;

  private:
    std::span<const base::Vec3f> m_positions;
    base::Vec3d m_centre;
    double m_radius = 0; ///< root mean square of the distances from the centre
};

} // namespace process
