// Surface: a tree with a definition. It answers what the points mean at a position (surface/README 2, 6):
//
//     f(x) = sum theta_i [(1-mu) n(x) + mu n_i] . (x - p_i) / w      zero on the surface, > 0 where the normals point
//     c(x) = sum theta_i p_i / w                                     centroid;  o(x) = |x - c(x)| off-centre value
//     g(x) = grad f                                                  the surface's true normal direction
//
// [Adamson07, 2, 7]; mu is our symmetric form.
//
// Two implementations of the same formulas: `evaluate` in float32, vectorised, relative to the query position, and
// `evaluateReference` in float64, plain loops. Tests compare them; `--precision double` asks for the second.
//
// A Surface is a value, cheap to copy; it holds its version alive. All functions are const and may run on any thread.
#pragma once

#include "core/base/mat3.h"
#include "core/surface/definition.h"
#include "core/tree/surfel_tree.h"

#include <span>

namespace surface {

/// What an answer is worth, as `query` prints it. Degenerate covers the cases of surface/README 2.5.
enum class Status : unsigned char { Ok, Outside, Degenerate, NotConverged, BeyondBoundary };
const char* statusName(Status status);

/// Why there is no answer: the degenerate cases of surface/README 2.5 by name. None where the status is Ok or
/// BeyondBoundary.
enum class Cause : unsigned char {
    None,
    NoSupport,         ///< no surfel has weight here
    OnePoint,          ///< a single one has
    TooFew,            ///< fewer than the frame needs
    Coincident,        ///< all at one place
    Collinear,         ///< all on one line
    CancellingNormals, ///< |m|/w too small
    ClosedGap,         ///< eigenvalues too close for an eigenvector
    NoGradient,        ///< f does not tell a direction here: the centre of a fitted sphere, a stationary point
};
const char* causeName(Cause cause);

/// How much to compute: each includes the ones before it.
enum class Need { Value, Gradient, Hessian };

/// Where the status is Outside or Degenerate, samples, weight, unit and agreement are what was counted, and everything
/// else is NaN. For rimls (surface/README 2.9) gradient and Hessian are the derivatives of the last pass's f with its
/// factors held constant.
template <class T>
struct Evaluation {
    Status status = Status::Outside;
    Cause cause = Cause::NoSupport;
    int samples = 0;              ///< surfels with weight
    T weight = 0;                 ///< w, sum of the weights
    T value = 0;                  ///< f, signed where the frame is oriented
    base::Vec3<T> centroid;       ///< c(x)
    base::Vec3<T> normal;         ///< n(x), the frame's unit normal
    base::Vec3<T> gradient;       ///< g(x) where asked for
    base::Mat3<T> hessian;        ///< where asked for
    base::Mat3<T> normalGradient; ///< dn_a/dx_b where the gradient was asked for (the bias term of resampling needs it)
    T offCentre = 0;              ///< o(x)
    T unit = 0;                   ///< h at x: weighted mean of the surfels' unitOf(support)
    T agreement = 0;              ///< |sum theta_i n_i| / w: 1 one flat sheet, 0 cancelling normals

    bool ok() const { return status == Status::Ok; }
};

using Evaluationf = Evaluation<float>;
using Evaluationd = Evaluation<double>;

/// A direction that chooses the sign of unoriented frames and, for near sheets, the sheet (its own normal); zero for
/// none: unoriented frames then keep an arbitrary sign, near sheets are put together or go by the nearest surfel
/// (surface/README 2.7).
struct OrientationHint {
    base::Vec3f direction;
};

class Surface {
  public:
    Surface() = default;
    Surface(tree::SurfelTree tree, SurfaceDefinition definition) : m_tree(std::move(tree)), m_definition(definition) {}

    const tree::SurfelTree& tree() const { return m_tree; }
    const SurfaceDefinition& definition() const { return m_definition; }
    /// The same surfels with all supports multiplied by `scale` (>= 1): where curvature is taken.
    Surface withSupportScale(float scale) const;
    float supportScale() const { return m_supportScale; }

    /// The definition's frame, or the nearest that the surfels have normals for: without a common sign hyperplanes
    /// stand in for summed normals, apss and rimls, without normals covariance-at-centroid for all of them
    /// (surface/README 2.4).
    Frame effectiveFrame() const;

    /// One position (one contact, one haptic step). Status is Ok, Outside, Degenerate or BeyondBoundary; in the last
    /// case all numbers are valid. With Need::Hessian, frames without vectorised sums for it are answered by the
    /// reference, rounded.
    Evaluationf evaluate(const base::Vec3f& x, Need need = Need::Gradient, const OrientationHint& hint = {}) const;
    /// Many positions, in parallel, best when neighbours in the list are neighbours in space. The same bits as one by
    /// one.
    void evaluate(std::span<const base::Vec3f> x, Need need, std::span<Evaluationf> out) const;
    Evaluationd evaluateReference(const base::Vec3d& x, Need need = Need::Gradient,
                                  const OrientationHint& hint = {}) const;

  private:
    tree::SurfelTree m_tree;
    SurfaceDefinition m_definition;
    float m_supportScale = 1;
};

} // namespace surface
