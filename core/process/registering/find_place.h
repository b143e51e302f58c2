// Where a scan belongs, without any hint: motions that bring two places onto two that look alike, normals and all, are
// tried by the hundred thousand, and the one that brings most of the scan onto the other's points is taken
// (process/README 13.2).
#pragma once

#include "core/process/registering/features.h"
#include "core/process/registering/rigid.h"

namespace process {

struct FoundPlace {
    Rigid pose;       ///< of `moving`, in the coordinates of `fixed`
    double share = 0; ///< of moving's points that then lie on fixed's, to a third of a spacing, and face the same way
};

/// At most so many places that differ, the most likely ones first. `spacing`: that both features were made with. The
/// same bits at any thread count. Throws base::Cancelled.
std::vector<FoundPlace> findPlaces(const Features& moving, const Features& fixed, float spacing, std::size_t most,
                                   const base::Progress& progress = {});

} // namespace process
