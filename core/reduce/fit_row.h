// One row of the fit: f at a place and its derivatives by the unknowns of the sites around (reduce/README 4.2), in
// double and relative to the place. Internal to the fit.
#pragma once

#include "core/base/vec.h"
#include "core/reduce/normal_equations.h"

#include <span>

namespace reduce {

/// A site as the fit moves it, from where it began.
struct FitSite {
    base::Vec3d start, normal0, along[2]; ///< a right-handed frame at the beginning
    double support = 0;
    std::array<double, unknowns>
        x{}; ///< offset, tilts, moves, logarithm of the support, times the support where they are none: all lengths

    base::Vec3d position() const { return start + normal0 * x[0] + along[0] * x[3] + along[1] * x[4]; }
    double reach() const { return support * std::exp(x[5] / support); }
    base::Vec3d tilted() const { return normal0 + along[0] * (x[1] / support) + along[1] * (x[2] / support); }
};

/// A site seen from the place.
struct FitTerm {
    const FitSite* site;
    std::array<float, unknowns>* d; ///< derivatives come here
    base::Vec3d y, normal;          ///< place less site; unit, on the place's side
    double sign = 1, length = 1;    ///< normal = sign x tilted / length
    double theta = 0, slope = 0;    ///< weight; weight,k = slope y_k
};

struct FitRow {
    bool valid = false;
    double residual = 0; ///< f / |g|, with the row's weight
};

/// Fills the derivatives, divided by |g| too. `normal`: of the dense surface. All zero where the surface is not told
/// at the place, or it is another sheet's.
FitRow fitRow(const base::Vec3d& place, const base::Vec3d& normal, bool oriented, std::span<FitTerm> terms);

} // namespace reduce
