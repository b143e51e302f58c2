// Normals of samples on faces: those of the fans at the corners, blended, as far as the face is small
// (mesh/README 8.3). A smooth normal over a large flat face contradicts the positions of its samples, and the surface
// ripples with them.
#pragma once

#include "core/mesh/faces/face_points.h"

namespace mesh {

class SampleNormals {
  public:
    /// Both must outlive this.
    SampleNormals(const FaceTopology& topology, std::span<const base::Vec3f> positions);

    const std::vector<base::Vec3f>& ofFans() const { return m_fans; }
    /// For samples about `spacing` apart. `tips`: 1 for each fan that tells nothing (face_tips.h); empty: all tell.
    /// REQUIRES: the point's triangle has an area.
    base::Vec3f at(const FacePoint& point, double spacing, std::span<const std::uint8_t> tips = {}) const;

  private:
    struct Side {
        base::Vec3f along; ///< unit
        double length = 0;
    };
    Side longestSide(std::uint32_t triangle) const;

    const FaceTopology& m_topology;
    std::span<const base::Vec3f> m_positions;
    std::vector<base::Vec3f> m_fans;
};

} // namespace mesh
