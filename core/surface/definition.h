// How the points of a model define its surface: weight, frame, supports, boundary (surface/README 2, 5). A plain
// value with defaults, compared with ==, written to files and sessions; its options: definition_options.h.
#pragma once

#include "core/surface/connectivity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace surface {

/// What the points sample. On a curve the surfels' normal channel holds unit tangents, or nothing (surface/README 7.1).
/// A complex is made of points, curves and patches that are glued to each other (complexes/README).
enum class Manifold { Surface, Curve, Complex };
/// Wendland's C2 and C4 kernels, and the Gaussian cut where it falls below 1e-8 (surface/README 2.1).
enum class Weight { Wendland, WendlandC4, Gaussian };
/// Where n comes from (surface/README 2.4): Normals, Hyperplanes, Covariance and so on, a row each of that file.
enum class Frame {
#define POINTCLAY_FRAME(frame, ...) frame,
#include "core/surface/frames/frame_rows.inl"
#undef POINTCLAY_FRAME
};
enum class Boundary { Auto, Limit, None };

struct SurfaceDefinition {
    Manifold manifold = Manifold::Surface;
    Frame frame = Frame::Normals;
    Weight weight = Weight::Wendland;
    /// One radius for all surfels, in model units (the scale of a Gaussian); 0: per surfel from its neighbours.
    float support = 0;
    /// Neighbours in support that the per-surfel radii aim at: h = s sqrt(K / pi). Used where `support` is 0.
    int neighbours = 38;
    Boundary boundary = Boundary::Auto;
    /// Off-centre limit in units of h: x is on the surface only where o(x) <= limit * h (surface/README 5.1). Set by
    /// whoever resolves Boundary::Auto for a model; infinity for closed ones.
    float boundaryLimit = std::numeric_limits<float>::infinity();
    bool knownRims = false;     ///< the surfels' attribute `rim` tells where the surface ends (rims.h)
    bool shrinkFree = true;     ///< the symmetric form mu = 1/2 (surface/README 2.6); false: mu = 0 [Adamson07]
    bool oneSheet = true;       ///< near sheets are kept apart (surface/README 2.7)
    bool interpolating = false; ///< weights over r^2: the surface passes through the points (surface/README 2.10)
    /// Curvature is taken on supports that reach over at least so many spacings (surface/README 6.3); 0: on those of
    /// the surface. Known for supports from neighbours; one support for all is taken at its word.
    float curvatureSpacings = 6;
    float apssBeta = 1;      ///< 1 fits spheres, 0 planes (surface/README 2.8)
    float rimlsSigma = 0.8f; ///< by how much normals may differ on one side of an edge (surface/README 2.9)
    /// Of a complex how its cells hang together; null for others. Compared by identity.
    std::shared_ptr<const Connectivity> connectivity;

    float mu() const { return shrinkFree ? 0.5f : 0.0f; }
    /// h / s of supports from neighbours.
    float unitInSpacings() const { return std::sqrt(static_cast<float>(neighbours) / std::numbers::pi_v<float>); }
    /// What supports are multiplied by where curvature is asked for.
    float curvatureScale() const { return support > 0 ? 1.0f : std::max(1.0f, curvatureSpacings / unitInSpacings()); }
    bool operator==(const SurfaceDefinition&) const = default;
};

/// s / h at the default of 38 neighbours, h = 3.5 s (surface/README 2.11): a guess where nobody counted neighbours.
constexpr double spacingOfUnit = 1 / 3.5;

/// A surfel's support radius is the distance at which its weight is zero. For the Gaussian exp(-s^2/H^2), cut where it
/// falls below 1e-8, that is H * gaussianReach.
constexpr float gaussianReach = 4.29193205f; // sqrt(ln 1e8)
/// Gaussian scale with the second moment of a Wendland support of 1 (surface/README 1.2): per-surfel supports use it.
constexpr float gaussianScale = 0.37267800f; // sqrt(5) / 6

/// Length that "units of h" means for a surfel whose reach is `support`.
constexpr float unitOf(Weight weight, float support) {
    return weight == Weight::Gaussian ? support / gaussianReach : support;
}

} // namespace surface
