// Curvature of the surface (surface/README 6.3): of the level set of f through a position, which on the surface is the
// surface.
//
// Second derivatives need more samples than f itself: they are taken on supports that reach over at least
// definition().curvatureSpacings spacings (surface/README 6.3), while f and its surface stay on their own. What is
// asked at a point of the surface is answered by the level set through it of the wider f.
//
// The Hessian of f is exact, not a difference. Curvatures are positive on a sphere with outward normals; unoriented
// frames choose the sign by the hint, else arbitrarily, for k1 and k2 together.
//
// All functions are const on the surface and may run on any thread.
#pragma once

#include "core/surface/surface.h"

namespace surface {

struct Curvature {
    /// Ok or, with a cause, Outside or Degenerate: then all numbers are NaN. Boundaries have no say here: whether the
    /// position is on the surface is a question for Surface::evaluate.
    Status status = Status::Outside;
    Cause cause = Cause::NoSupport;
    double k1 = 0, k2 = 0;              ///< principal curvatures, k1 >= k2
    base::Vec3d direction1, direction2; ///< their unit directions; with the unit gradient a right-handed basis
    base::Vec3d normal;                 ///< the unit gradient of the f that was differentiated

    bool ok() const { return status == Status::Ok; }
    double mean() const { return 0.5 * (k1 + k2); }
    double gauss() const { return k1 * k2; }
};

/// From derivatives at hand, whatever supports they are from. REQUIRES: `e` was evaluated with Need::Hessian.
Curvature curvatureOf(const Evaluationd& e);

/// At one position, in double.
Curvature curvatureReference(const Surface& surface, const base::Vec3d& x, const OrientationHint& hint = {});

/// At many positions, in parallel, best when neighbours in the list are neighbours in space: as exact as float allows.
/// The same bits at any thread count, and for each position the same whatever stands beside it.
void curvature(const Surface& surface, std::span<const base::Vec3f> x, std::span<Curvature> out);

} // namespace surface
