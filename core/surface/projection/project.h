// The three projections onto the surface (surface/README 3.1), in float32 and in the float64 reference.
//
//     basic              x_{k+1} = Q(x_k, x_k)     lands on the surface somewhere near
//     almost orthogonal  x_{k+1} = Q(x_0, x_k)     x_0 - foot is parallel to the frame normal there
//     orthogonal         x_{k+1} = Qo(x_0, x_k)    x_0 - foot is parallel to the gradient: a closest point
//
// Positions outside all supports start from their nearest surfel (surface/README 3.3). Steps are relaxed by what the
// last two tell, which damps oscillation far from the surface. What did not converge says so in its status; its numbers
// are then not to be used.
#pragma once

#include "core/surface/surface.h"

namespace surface {

enum class Projector { Basic, Almost, Orthogonal };

template <class T>
struct Projection {
    Status status = Status::Outside;
    base::Vec3<T> foot;
    Evaluation<T> at;    ///< evaluation at the foot, with gradient where the projector needed it or it was asked for
    int iterations = 0;  ///< steps
    int evaluations = 0; ///< of f, with or without derivatives

    bool ok() const { return status == Status::Ok; }
};

struct ProjectOptions {
    Projector projector = Projector::Orthogonal;
    double tolerance = 0; ///< last step in units of h; 0: 1e-6 in float, 1e-12 in double
    int maxIterations = 30;
    bool checkBoundary = true;  ///< feet beyond the boundary limit get Status::BeyondBoundary
    Need need = Need::Gradient; ///< what `at` must hold at the foot
};

/// Of the last step, in units of h.
template <class T>
constexpr T toleranceOf(const ProjectOptions& options) {
    return static_cast<T>(options.tolerance > 0 ? options.tolerance : std::is_same_v<T, double> ? 1e-12 : 1e-6);
}

Projection<float> project(const Surface& surface, const base::Vec3f& x, const ProjectOptions& options = {},
                          const OrientationHint& hint = {});
Projection<double> projectReference(const Surface& surface, const base::Vec3d& x, const ProjectOptions& options = {},
                                    const OrientationHint& hint = {});
/// Many positions in parallel; the same bits as one by one.
void project(const Surface& surface, std::span<const base::Vec3f> x, const ProjectOptions& options,
             std::span<Projection<float>> out);

} // namespace surface
