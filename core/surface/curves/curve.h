// Curves in space behind points (surface/README 7.1): the zero set of a vector-valued function of codimension two,
//
//     F(x) = (I - t t^T) (x - c(x))       t(x) the direction of the curve, F zero on it
//
// [Adamson07, 2.3, 3.1, 7]. |F| has no derivative on the curve, so all iterations use the vector F itself. Everything
// is float64: curves have few points and their iterations are short.
//
// The direction is the dominant eigenvector of the frame's matrix: covariance, covariance-at-centroid (also what the
// frames that sum normals of surfaces mean here), centroid-gradient, or hyperplanes, which reads the surfels' normal
// channel as unoriented unit tangents. Its sign is arbitrary.
#pragma once

#include "core/surface/projection/project.h"

namespace surface {

struct CurveEvaluation {
    Status status = Status::Outside;
    Cause cause = Cause::NoSupport;
    int samples = 0;       ///< surfels with weight
    double weight = 0;     ///< w
    double unit = 0;       ///< h at x
    double offCentre = 0;  ///< |x - c|
    base::Vec3d centroid;  ///< c(x)
    base::Vec3d direction; ///< t(x), the frame's unit direction
    base::Vec3d value;     ///< F(x), from the curve to x
    base::Mat3d gradient;  ///< dF_a/dx_b, from Need::Gradient
    base::Vec3d tangent;   ///< ker DF: the curve's own unit tangent, from Need::Gradient
    base::Vec3d curvature; ///< K = -DF^+ (t^T D^2F t): towards the centre of the osculating circle, from Need::Hessian

    bool usable() const { return status == Status::Ok || status == Status::BeyondBoundary; }
};

/// Status as Surface::evaluate gives it: Outside, Degenerate with its cause, BeyondBoundary, Ok.
CurveEvaluation evaluateCurve(const Surface& curve, const base::Vec3d& x, Need need = Need::Gradient);

struct CurveProjection {
    Status status = Status::Outside;
    base::Vec3d foot;
    CurveEvaluation at;
    int iterations = 0;

    bool ok() const { return status == Status::Ok; }
};

/// The three projections (surface/README 3.1) onto the curve. `options.need` says what `at` holds at the foot.
CurveProjection projectOnCurve(const Surface& curve, const base::Vec3d& x, const ProjectOptions& options = {});

} // namespace surface
