// Where the fit of rims asks for o (reduce/README 4.4): at the rims, and beyond them, where rows at the rims alone
// leave it free and the surface would begin once more. Internal to the fit.
#pragma once

#include "core/reduce/fit_row.h"
#include "core/reduce/rim_fit.h"

namespace reduce {

struct RimRows {
    std::vector<base::Vec3f> position, normal;
    std::size_t atRims = 0; ///< the first ones; the others are beyond

    /// That of `rimRow`; beyond rims, where o is as large as it is to be: all zero.
    FitRow row(std::size_t i, bool oriented, double limit, std::span<FitTerm> terms) const;
};

/// REQUIRES: some site. Throws base::Cancelled.
RimRows rimRowsOf(const Rims& rims, const NumberedTree& sites);

} // namespace reduce
