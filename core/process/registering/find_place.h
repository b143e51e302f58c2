// Where a scan belongs, without any hint: motions that bring three places that look alike onto each other are tried by
// the hundred thousand, and the one that brings most of the scan onto the other's points is taken
// (process/README 13.2).
#pragma once

#include "core/process/registering/features.h"
#include "core/process/registering/rigid.h"

namespace process {

struct FoundPlace {
    Rigid pose;       ///< of `moving`, in the coordinates of `fixed`
    double share = 0; ///< of moving's points that then have one of fixed within 1.5 spacings that faces the same way
};

/// `spacing`: that both features were made with. The same bits at any thread count. Throws base::Cancelled.
FoundPlace findPlace(const Features& moving, const Features& fixed, float spacing, const base::Progress& progress = {});

} // namespace process
