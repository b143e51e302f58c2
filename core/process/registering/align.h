// Scans brought together: each one's points onto the surfaces of the others, all at once (process/README 13.1).
//
// Every round looks for the exact feet of some points of each model on every other model's surface and moves all models
// but the first so that the weighted distances along the feet's normals become least: one linear system for all of
// them, so that no error adds up around a loop. What lies beyond a surface's boundary, faces another way or is too far
// has no say.
#pragma once

#include "core/process/registering/rigid.h"
#include "core/surface/surface.h"

namespace process {

/// A model with where it is: its coordinates -> those of all.
struct Placed {
    surface::Surface surface;
    Rigid pose;
    double rms = 0;     ///< distances of its points that count, along normals
    double overlap = 0; ///< share of its points that have a foot on another model
    bool held = true;   ///< else it slides along the others, and fits as well where it is moved to
    bool unique = true; ///< else it was found to fit nearly as well in another place
};

struct AlignOptions {
    std::size_t points = 2000; ///< looked at in each model and round
    /// How far feet may be in the first round; 0: a fifth of the first model's diagonal.
    double reach = 0;
    int mostRounds = 60;
};

struct Alignment {
    int rounds = 0;
    bool settled = false; ///< the last round moved nothing
    double slide = 0;     ///< by so much models were moved to see whether they are held
};

/// Moves all but the first. The same bits at any thread count. Throws base::Error where a model has no foot on any
/// other, base::Cancelled.
Alignment align(std::vector<Placed>& models, const AlignOptions& options = {}, const base::Progress& progress = {});

} // namespace process
