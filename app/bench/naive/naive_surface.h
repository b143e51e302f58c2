// The naive surface that ours is measured against: a radius search by nanoflann for every position, then plain loops
// over what was found with Eigen in double, the same formulas (surface/README) and one thread.
//
// It speaks summed normals with the Wendland weight, per-surfel supports, oriented normals; one sheet.
#pragma once

#include "core/surface/projection/project.h"

#include <memory>

namespace bench {

class NaiveCloud;

struct NaiveEvaluation {
    bool valid = false;
    double value = 0;
    double unit = 0; ///< weighted mean of the supports
    base::Vec3d centroid, normal, gradient;
    base::Mat3d hessian;
};

class NaiveSurface {
  public:
    explicit NaiveSurface(const surface::Surface& surface);
    ~NaiveSurface();

    /// Does the surface mean what is computed here?
    static bool speaks(const surface::Surface& surface);

    const NaiveCloud& cloud() const { return *m_cloud; }
    /// Supports are multiplied by `scale`.
    NaiveEvaluation evaluate(const base::Vec3d& x, surface::Need need, double scale = 1) const;
    /// Fixed-point iterations until a step is below `tolerance` h, 30 at most; false where they end otherwise.
    bool project(const base::Vec3d& x, surface::Projector projector, double tolerance, base::Vec3d& foot) const;

  private:
    std::unique_ptr<NaiveCloud> m_cloud;
    double m_mu;
};

} // namespace bench
