// The naive rays that ours are measured against: Embree's oriented discs over the surfels say where to begin, Newton
// steps along the ray go on from there to the root, each with sums over a radius search (naive_surface.h). One thread.
// The only header that stands before Embree.
#pragma once

#include "app/bench/naive/naive_surface.h"
#include "core/base/ray.h"

#include <limits>

namespace bench {

struct NaiveHit {
    double t = std::numeric_limits<double>::infinity(); ///< infinite: no hit
    base::Vec3d normal;                                 ///< unit gradient
};

class NaiveRays {
  public:
    /// REQUIRES: a surface that NaiveSurface speaks; `surface` outlives this.
    explicit NaiveRays(const NaiveSurface& surface);
    ~NaiveRays();
    NaiveRays(const NaiveRays&) = delete;
    NaiveRays& operator=(const NaiveRays&) = delete;

    /// The first hit, to about 1e-5 h. REQUIRES: a unit direction.
    NaiveHit intersect(const base::Rayd& ray) const;

  private:
    struct Discs;
    const NaiveSurface& m_surface;
    std::unique_ptr<Discs> m_discs;
};

} // namespace bench
