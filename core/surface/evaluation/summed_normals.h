// The common case of an evaluation in float, without what the others need: summed oriented normals, weights as they
// are, surfels that agree. Where anything is special (outside, too few surfels, near sheets) it says so, and the
// assembler takes over; where it answers, its numbers are the assembler's.
#pragma once

#include "core/surface/evaluation/moments_float.h"
#include "core/surface/rims.h"

namespace surface {

class SummedNormals {
  public:
    explicit SummedNormals(const Surface& surface);

    /// Is this case that of the surface at all?
    bool applies() const { return m_applies; }
    Weight weight() const { return m_sums.weight; }
    float supportScale() const { return m_sums.scale; }
    int shape() const { return m_sums.shape; }
    float mu() const { return m_mu; }
    float boundaryLimit() const { return m_limit; }
    /// What kernels say of x, who know the limit alone, once rims have their say.
    Status settled(Status told, const base::Vec3f& x) const {
        return told == Status::BeyondBoundary && !mayEnd(*m_surface, x) ? Status::Ok : told;
    }
    /// Computes everything up to `need`; false, with `out` left as it is, where the position is special.
    /// REQUIRES: applies().
    bool evaluate(ClusterSpan clusters, const base::Vec3f& x, Need need, Evaluationf& out) const;

  private:
    KernelInput input(ClusterSpan clusters, const base::Vec3f& x) const;
    bool values(ClusterSpan clusters, const base::Vec3f& x, Evaluationf& out) const;
    bool gradients(ClusterSpan clusters, const base::Vec3f& x, Evaluationf& out) const;
    bool hessians(ClusterSpan clusters, const base::Vec3f& x, Evaluationf& out) const;
    struct Sums;
    bool begin(const Sums& sums, const base::Vec3f& x, Evaluationf& out) const;

    bool m_applies;
    KernelInput m_sums; ///< without clusters and position
    float m_mu, m_limit;
    const Surface* m_surface; ///< for its rims
};

} // namespace surface
