// How far apart samples of faces are to be: each connected piece has a spacing of its own, which gets less towards
// pieces that are sampled more finely, so that supports can follow (mesh/README 8.3).
//
// Large triangles are cut into parts of nearly one spacing, of which samples are drawn.
#pragma once

#include "core/mesh/faces/face_topology.h"
#include "core/mesh/faces/inner_places.h"
#include "core/mesh/faces/near_spacings.h"

#include <optional>

namespace mesh {

/// A part of a triangle.
struct FacePart {
    std::uint32_t triangle = 0;
    float b[3], c[3];  ///< of its corners: barycentric coordinates as FacePoint has them
    double weight = 0; ///< samples that it is to have
    double most = 0;   ///< spacing in it
    bool even = false; ///< it is that everywhere
};

class FaceDensity {
  public:
    /// `spacings`: of each piece, > 0. The topology must outlive this. What is near the places of finer pieces is
    /// sampled as these ask (near_spacings.h), with spacings that differ by `slope` over a distance. The same at any
    /// thread count. Throws base::Cancelled.
    FaceDensity(const FaceTopology& topology, std::span<const base::Vec3f> positions, std::vector<double> spacings,
                std::vector<SpacedPlace> places = {}, double slope = 0);

    double at(const base::Vec3d& place, std::uint32_t triangle) const;
    /// The same, sooner, of a place in one of the parts below.
    double at(const base::Vec3d& place, const FacePart& part) const;
    double least() const { return m_least; }
    /// Of all pieces: the parts whose spacings differ little.
    const std::vector<FacePart>& parts() const { return m_parts; }

  private:
    void cut(std::span<const base::Vec3f> positions, double slope);

    const FaceTopology& m_topology;
    std::vector<double> m_spacings;
    double m_least;
    std::optional<NearSpacings> m_near;
    std::vector<FacePart> m_parts;
};

/// Samples that parts are to have, without those of places that are inside.
double samplesOn(std::span<const FacePart> parts, const FaceTopology& topology, const InnerPlaces* inside);

} // namespace mesh
