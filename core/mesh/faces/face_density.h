// How far apart samples of faces are to be: each connected piece has a spacing of its own, which gets less towards
// pieces that are sampled more finely, so that supports can follow (mesh/README 8.3).
//
// Large triangles are cut into parts of nearly one spacing, of which samples are drawn.
#pragma once

#include "core/mesh/faces/face_draws.h"
#include "core/mesh/faces/inner_places.h"
#include "core/mesh/faces/near_spacings.h"

#include <optional>

namespace mesh {

class FaceDensity {
  public:
    /// `spacings`: of each piece, > 0. Topology and positions must outlive this. What is near the places of finer
    /// pieces is sampled as these ask (near_spacings.h), with spacings that differ by `slope` over a distance. The same
    /// at any thread count. Throws base::Cancelled.
    FaceDensity(const FaceTopology& topology, std::span<const base::Vec3f> positions, std::vector<double> spacings,
                std::vector<SpacedPlace> places = {}, double slope = 0);

    double at(const base::Vec3d& place, std::uint32_t triangle) const;
    /// The same, sooner, of a place in one of the parts below.
    double at(const base::Vec3d& place, const FacePart& part) const;
    /// Of a place on a piece of that spacing.
    double near(const base::Vec3d& place, double own) const { return m_near ? m_near->at(place, own) : own; }
    double least() const { return m_least; }
    /// Of all pieces: the parts whose spacings differ little.
    const std::vector<FacePart>& parts() const { return m_parts; }
    /// As many as that asks for, without places that are inside.
    double samples(const InnerPlaces* inside) const;

  private:
    void cut(double slope);

    const FaceTopology& m_topology;
    std::span<const base::Vec3f> m_positions;
    std::vector<double> m_spacings;
    double m_least;
    std::optional<NearSpacings> m_near;
    std::vector<FacePart> m_parts;
};

} // namespace mesh
