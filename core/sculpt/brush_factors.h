// What multiplies a surfel's share of a dab for every tool alike: front-facing only, connected only, the stamp. (The
// falloff and the mask stand in tools/displace.h.)
//
//     a' = phi a,    grad a' = phi grad a + a grad phi          phi = product of the factors, each 0 to 1
//
// Front-facing: smoothstep of the cosine between the normal and the direction to the viewer, 0 from 90 degrees on, 1 up
//     to 70 degrees; of unoriented surfels the side towards the viewer counts. Its gradient needs the curvature: it is
//     the least-squares plane through the factors of the surfel's cluster, taken along the surface.
// Connected: 1 or 0 (brush_connected.h). The surface ends where it changes, so that its gradient is 0.
// Stamp: the image's value and its exact gradient (brush_stamp.h), seen along the dab's area normal.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

/// 16 factors and their gradients.
struct FactorLanes {
    alignas(64) float value[surfel::clusterSize];
    alignas(64) float gx[surfel::clusterSize], gy[surfel::clusterSize], gz[surfel::clusterSize];
};

class BrushFactors {
  public:
    /// Keeps what `dab` shares; the dab may go.
    explicit BrushFactors(const Dab& dab);
    /// Every factor is 1: nothing need be asked.
    bool none() const { return !m_frontFacing && !m_stamp && !m_connected; }

    /// Factors of a cluster of block `number` of the version that the dab works on.
    void fill(std::uint32_t number, const surfel::SurfelBlock& block, int cluster, FactorLanes& out) const;
    /// Multiplies 16 weights, where the tool needs no gradient.
    void multiply(std::uint32_t number, const surfel::SurfelBlock& block, int cluster, float* weight) const;
    /// Multiplies 16 amounts and their gradients by the formula above.
    void multiply(std::uint32_t number, const surfel::SurfelBlock& block, int cluster, float* amount, float* gx,
                  float* gy, float* gz) const;

  private:
    void face(const surfel::SurfelBlock& block, int cluster, FactorLanes& out) const;
    void press(const surfel::SurfelBlock& block, int cluster, FactorLanes& out) const;

    bool m_frontFacing, m_oriented;
    base::Vec3f m_view, m_centre, m_right, m_up;
    float m_radius;
    int m_level;
    std::shared_ptr<const BrushStamp> m_stamp;
    std::shared_ptr<const Connected> m_connected;
};

} // namespace sculpt
