// One row of the fit: f at a place and its derivatives by the unknowns of the sites around (reduce/README 4.2), in
// double and relative to the place. Internal to the fit.
//
// Shapes of supports are two numbers p, q: the metric in the tangent plane is exp [p q; q -p] over the squared size, so
// that none is singular at the ball, and the area stays while they change.
#pragma once

#include "core/base/vec.h"
#include "core/reduce/normal_equations.h"

#include <span>

namespace reduce {

/// A site as the fit moves it, from where it began.
struct FitSite {
    base::Vec3d start, normal0, along[2]; ///< a right-handed frame at the beginning
    double support = 0;                   ///< of a ball of the same area
    double shape0[2] = {0, 0};            ///< p and q at the beginning
    /// Offset, tilts, moves, logarithm of the support, shape, times the support where they are none: all lengths.
    std::array<double, mostUnknowns> x{};

    base::Vec3d position() const { return start + normal0 * x[0] + along[0] * x[3] + along[1] * x[4]; }
    double p() const { return shape0[0] + x[6] / support; }
    double q() const { return shape0[1] + x[7] / support; }
    /// Logarithm of a1 / a2.
    double stretch() const { return std::hypot(p(), q()); }
    /// The large semi-axis.
    double reach() const { return support * std::exp(x[5] / support + 0.5 * stretch()); }
    /// b of the support (surfel/shape.h).
    base::Vec3d shape() const;
    /// Takes p and q from b, and the support from the large semi-axis.
    void setShape(const base::Vec3d& b, double reach);
    base::Vec3d tilted() const { return normal0 + along[0] * (x[1] / support) + along[1] * (x[2] / support); }
};

/// A site seen from the place.
struct FitTerm {
    const FitSite* site;
    std::array<float, mostUnknowns>* d; ///< derivatives come here
    base::Vec3d y, normal;              ///< place less site; unit, on the place's side
    double sign = 1, length = 1;        ///< normal = sign x tilted / length
    double theta = 0, slope = 0;        ///< weight; weight,k = slope (y + b (b.y))_k
    double reach = 0;
    base::Vec3d b{};
    double along = 0; ///< b.y

    base::Vec3d way() const { return y + b * along; }
};

struct FitRow {
    bool valid = false;
    double residual = 0; ///< f / |g|, with the row's weight
};

/// What the sites around a place sum to: as one sheet, or where another one is near as the own side of two solids.
struct FitSums {
    double weight = 0;
    double against = 0;          ///< of what faces the other way
    base::Vec3d offset, normals; ///< sum theta y, sum theta n
    double support = 0;          ///< the largest
    bool parted = false;
    double agreement() const { return weight > 0 ? length(normals) / weight : 0; }
};

/// In two solids each is summed on supports of this part (surface/README 2.7).
constexpr double partSupport = 0.75;

/// Fills all of the terms but the derivatives, which become zero.
FitSums sumTerms(const base::Vec3d& place, const base::Vec3d& normal, bool oriented, std::span<FitTerm> terms);

/// Fills the derivatives, divided by |g| too. `normal`: of the dense surface. All zero where the surface is not told
/// at the place, or it is another sheet's.
FitRow fitRow(const base::Vec3d& place, const base::Vec3d& normal, bool oriented, std::span<FitTerm> terms);

} // namespace reduce
