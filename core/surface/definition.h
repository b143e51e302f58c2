// How the points of a model define its surface: weight, frame, supports, boundary (alg. 2, 6). A plain value with
// defaults, compared with ==, written to files and sessions under the names of INTERFACES (see definition_text.h).
#pragma once

#include <limits>

namespace surface {

enum class Weight { Wendland, Gaussian };
enum class Frame { Normals, Hyperplanes, Covariance, CovarianceAtCentroid };
enum class Boundary { Auto, Limit, None };

struct SurfaceDefinition {
    Frame frame = Frame::Normals;
    Weight weight = Weight::Wendland;
    /// One radius for all surfels, in model units (the scale of a Gaussian); 0: per surfel from its neighbours.
    float support = 0;
    /// Neighbours in support that the per-surfel radii aim at: h = s sqrt(K / pi). Used where `support` is 0.
    int neighbours = 38;
    Boundary boundary = Boundary::Auto;
    /// Off-centre limit in units of h: x is on the surface only where o(x) <= limit * h (alg. 6). Set by whoever
    /// resolves Boundary::Auto for a model; infinity for closed ones.
    float boundaryLimit = std::numeric_limits<float>::infinity();
    bool shrinkFree = true; ///< the symmetric form mu = 1/2 (alg. 2.6); false is the dissertation's own, mu = 0
    bool oneSheet = true;   ///< second pass where near sheets meet (|m|/w < 0.7)

    float mu() const { return shrinkFree ? 0.5f : 0.0f; }
    bool operator==(const SurfaceDefinition&) const = default;
};

/// A surfel's support radius is the distance at which its weight is zero. For the Gaussian exp(-s^2/H^2), cut where it
/// falls below 1e-8, that is H * gaussianReach.
constexpr float gaussianReach = 4.29193205f; // sqrt(ln 1e8)
/// Gaussian scale with the second moment of a Wendland support of 1 (alg. 0): per-surfel supports use it.
constexpr float gaussianScale = 0.37267800f; // sqrt(5) / 6

/// Length that "units of h" means for a surfel whose reach is `support`.
constexpr float unitOf(Weight weight, float support) {
    return weight == Weight::Gaussian ? support / gaussianReach : support;
}

} // namespace surface
