// The density of a reduced set once more, by what a first one errs after all (reduce/README 3.4): the predicted error
// of density.h knows no supports that reach over other sheets, and no features that too few samples carry.
#pragma once

#include "core/reduce/rim_fit.h"

namespace reduce {

/// The shares that made `sites`, more where their surface errs more than elsewhere, or ends inside beside one of the
/// rims; together `count` again; `oneSheet` as the reduced model will have it. In parallel; the same bits at any thread
/// count. Throws base::Cancelled. `foreseen`, if given, gets the distance between the surfaces (rms) that they would
/// leave: (3b).
std::vector<float> sharesByResult(const Places& places, const Sites& sites, std::vector<float> shares,
                                  std::size_t count, const Rims& rims, bool oneSheet, double* foreseen = nullptr);

} // namespace reduce
