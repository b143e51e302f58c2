// The naive surface that ours is measured against: a radius search by nanoflann for every position, then plain loops
// over what was found with Eigen in double, the same formulas (alg. 2, 3, 7) and one thread.
//
// Points lie in memory in the tree's order, which alone makes it several times faster than in a file's. It speaks
// summed normals with the Wendland weight, per-surfel supports, oriented normals; one sheet.
#pragma once

#include "core/surface/projection/project.h"

#include <memory>

namespace bench {

struct NaiveEvaluation {
    bool valid = false;
    double value = 0;
    base::Vec3d centroid, normal, gradient;
    base::Mat3d hessian;
};

class NaiveSurface {
  public:
    explicit NaiveSurface(const surface::Surface& surface);
    ~NaiveSurface();

    /// Does the surface mean what is computed here?
    static bool speaks(const surface::Surface& surface);

    /// Supports are multiplied by `scale`.
    NaiveEvaluation evaluate(const base::Vec3d& x, surface::Need need, double scale = 1) const;
    /// Fixed-point iterations until a step is below `tolerance` h, 30 at most; false where they end otherwise.
    bool project(const base::Vec3d& x, surface::Projector projector, double tolerance, base::Vec3d& foot) const;
    /// Marches from outside: as far as the nearest point allows where there is no support, then by the value until the
    /// plane iteration stands still to 1e-5 h. Returns the distance of the first hit, infinity for none.
    double intersect(const base::Rayd& ray) const;

  private:
    struct Index;
    std::unique_ptr<Index> m_index;
};

} // namespace bench
