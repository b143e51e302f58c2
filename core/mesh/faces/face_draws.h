// Points on faces by chance: as many on each triangle, or part of one, as it weighs.
#pragma once

#include "core/mesh/faces/face_topology.h"

#include <array>
#include <span>
#include <vector>

namespace mesh {

class InnerPlaces;

struct FacePoint {
    std::uint32_t triangle = 0; ///< of the topology
    float b = 0, c = 0;         ///< barycentric coordinates of corners 1 and 2; corner 0 has 1 - b - c

    /// Of the corners, in their order.
    std::array<float, 3> weights() const { return {1 - b - c, b, c}; }
};

/// Where a point is.
base::Vec3d placeOf(const FacePoint& point, const FaceTopology& topology, std::span<const base::Vec3f> positions);

/// A part of a triangle.
struct FacePart {
    std::uint32_t triangle = 0;
    float b[3], c[3];  ///< of its corners: barycentric coordinates as FacePoint has them
    double weight = 0; ///< samples that it is to have
    double most = 0;   ///< spacing in it
    bool even = false; ///< it is that everywhere

    /// A point of the part, by its own corners, as one of the triangle.
    FacePoint within(float ofSecond, float ofThird) const;
};

class FaceDraws {
  public:
    /// Whole triangles, by area.
    explicit FaceDraws(const FaceTopology& topology);
    /// By weight. The parts must outlive this.
    explicit FaceDraws(std::span<const FacePart> parts);

    double total() const { return m_sums.back(); } ///< of the weights
    struct Draw {
        FacePoint point;
        std::uint32_t part = 0;
    };
    /// The i-th of n: one in each of n equal shares of the weight (stratified). The same each time.
    Draw at(std::size_t i, std::size_t n) const;
    /// Of the total, what does not lie inside, from some draws; 1 where nothing does.
    double outerShare(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                      const InnerPlaces* inside) const;

  private:
    std::span<const FacePart> m_parts; ///< none: whole triangles
    std::vector<double> m_sums;        ///< of the weights up to each
};

} // namespace mesh
