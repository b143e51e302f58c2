// Where a plane cuts a model with cells (cells/README 10): the curves of surface/curves/section.h, with the corners
// that they have where cells meet.
//
// The curve of each cell is followed as far as the local Boolean leaves it, its end found by bisection. Ends of two
// cells at a seam are the same place then, which the joined curve has twice, with the normals of both sides.
#pragma once

#include "core/cells/cell_surface.h"
#include "core/surface/curves/section.h"

namespace cells {

/// As surface::findSection; for models without cells it is that, for complexes their own (complex_section.h).
std::vector<surface::SectionCurve> findSection(const surface::Surface& surface, const base::Plane& plane,
                                               const base::Progress& progress = {},
                                               const surface::TraceOptions& options = {});
/// For many sections of one model.
std::vector<surface::SectionCurve> findSection(const CellSurface& surface, const base::Plane& plane,
                                               const base::Progress& progress = {},
                                               const surface::TraceOptions& options = {});

} // namespace cells
