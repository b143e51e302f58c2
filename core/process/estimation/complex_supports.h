// Supports of the points of a complex (complexes/README 3): each cell by itself, because its points never speak for
// another one.
#pragma once

#include "core/surface/definition.h"
#include "core/surfel/surfel.h"

namespace process {

/// Of patches h = s sqrt(K / pi), with 0.93 of the mean distance of the six nearest of the cell as s; of curves the
/// same h with the mean distance of the two nearest; of points the mean of the curves that end there. One for all where
/// the definition says so; those > 0 stay where `keep`. REQUIRES: `connectivity`. Throws base::Error for points that
/// belong to no cell of it.
void assignComplexSupports(surfel::SurfelList& points, const surface::SurfaceDefinition& definition, bool keep);

} // namespace process
