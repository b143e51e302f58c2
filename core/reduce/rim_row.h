// One row of the fit of rims: how far from a place the surface ends, and its derivatives by the unknowns of the sites
// around (reduce/README 4.4), in double and relative to the place. Internal to the fit.
#pragma once

#include "core/reduce/fit_row.h"

#include <optional>

namespace reduce {

/// Off-centre value over support, as the boundary limit is asked of it; nothing where no site has weight. `normal`: of
/// the dense surface.
std::optional<double> offCentreAt(const base::Vec3d& place, const base::Vec3d& normal, bool oriented,
                                  std::span<FitTerm> terms);

/// (o - L h) / |its slope along the surface|. Fills the derivatives by moves and sizes, those by all else are zero.
/// All zero where o does not tell of a rim.
FitRow rimRow(const base::Vec3d& place, const base::Vec3d& normal, bool oriented, double limit,
              std::span<FitTerm> terms);

} // namespace reduce
