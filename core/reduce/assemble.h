// From sites to a surface: what the surfels carry, the definition, the boundary (reduce/README 5).
#pragma once

#include "core/base/progress.h"
#include "core/reduce/rim_fit.h"

namespace reduce {

/// Surfels at the sites with the colours, masks and further attributes of the model around them; `neighbours` becomes
/// the definition's. A surface in the shrink-free form by summed normals, without a boundary yet. In parallel; the same
/// bits at any thread count.
surface::Surface assemble(const surface::Surface& model, const Sites& sites, int neighbours);

/// The definition of such a surface, made of a model's.
surface::SurfaceDefinition reducedDefinition(const surface::SurfaceDefinition& model, int neighbours);

/// The same surface ends where the model does: with the least off-centre limit that keeps all places, and `beyond` more
/// (in supports) where these do not go to the rim.
surface::Surface bounded(const surface::Surface& model, const surface::Surface& surface, const Places& places,
                         float beyond, const base::Progress& progress = {});

/// The same where samples are fitted to the model's rims, for that limit, or more where places would be lost. It knows
/// its rims, where it is left to the model where it ends (surface/rims.h).
surface::Surface endingAtRims(const surface::Surface& model, const surface::Surface& surface, const Places& places,
                              const Rims& rims, float limit, const base::Progress& progress = {});

} // namespace reduce
