// Support radii: one for all, or per surfel h = s sqrt(K / pi) from the local spacing, graded so that neighbours' radii
// differ by at most half their distance (process/README 1.3), because ungraded supports ripple. Grading neither raises
// nor lowers on the whole: it takes the graded field nearest to the wanted one, and never less than half of what was
// wanted. Outliers take the radii of what they stand beside (process/README 1.3).
#pragma once

#include "core/base/progress.h"
#include "core/surface/definition.h"
#include "core/surfel/surfel.h"

namespace process {

/// Sets every surfel's support (its reach, see definition.h).
void assignSupports(surfel::SurfelList& points, const surface::SurfaceDefinition& definition,
                    const base::Progress& progress = {});

} // namespace process
