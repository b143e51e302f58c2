// Places tried out: exactly, where features only guess (process/README 13.2). Inside this folder.
#pragma once

#include "core/process/registering/align.h"

namespace process {

struct Agreement {
    Rigid pose;
    bool unique = true; ///< no other of the places fits nearly as well
};

/// The best of the places for a model, tried out: from each it settles on the one of `placed` that most of it lies on
/// there. The share of points that lie on it counts, as far as they do as closely as those of the closest trial, and
/// less where the model is not held: a ball finds every other one. `wide`: how far guesses may be off. REQUIRES: some
/// places. The same bits at any thread count. Throws base::Cancelled.
Agreement bestAgreement(const std::vector<Placed>& placed, const surface::Surface& moving,
                        const std::vector<Rigid>& places, double wide, const base::Progress& progress = {});

} // namespace process
