// A quadric over a plane, fitted by least squares to heights beside one place: what the surface is there without
// deciding in advance how it bends.
//
//     z = c0 + c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2          x, y, z in a frame whose origin is the place
//
// Unlike a plane it neither cuts crests off nor fills hollows, to the second order. Samples are added one after
// another, so that fits to more and more of them cost one solution each. Values; no allocation.
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

/// A right-handed frame at a place: u, v along the surface, n across it.
struct LocalFrame {
    base::Vec3d origin, u, v, n;
};

/// By the covariance of a position and its nearest, in double. `side`: n is turned to it unless that is zero.
LocalFrame planeFrame(std::span<const base::Vec3f> positions, std::size_t i, std::span<const std::uint32_t> near,
                      const base::Vec3f& side);

struct QuadricFit {
    int terms = 0; ///< 6, or 3, 1 where the samples do not tell more; 0 without any
    double c[6] = {};
    double variance = 0; ///< of c0, where each sample's height has a variance of 1

    double at(double x, double y) const { return c[0] + x * (c[1] + c[3] * x + c[4] * y) + y * (c[2] + c[5] * y); }
    /// Along the surface's normal at the origin, from the origin to the surface's tangent plane there.
    double distance() const { return c[0] / std::sqrt(1 + c[1] * c[1] + c[2] * c[2]); }
    base::Vec3d normal(const LocalFrame& frame) const {
        return base::normalized(frame.n - frame.u * c[1] - frame.v * c[2], frame.n);
    }
};

class QuadricSums {
  public:
    /// `scale`: about the distance of the farthest sample, a unit in which sums are well conditioned.
    explicit QuadricSums(double scale) : m_scale(1 / scale) {}

    void add(double x, double y, double z, double weight = 1);
    void add(const LocalFrame& frame, const base::Vec3f& p, double weight = 1);
    QuadricFit fit() const;

  private:
    double m_scale;
    double m_samples = 0;
    double m_normal[6][6] = {}; ///< upper half
    double m_right[6] = {};
};

} // namespace process
