// Where a plane cuts a complex: the curves of surface/curves/section.h, with the corners that they have where patches
// meet, and ends where the complex ends.
//
// Each patch has curves of its own, which are followed until they pass its boundary; the end is found by bisection. Two
// patches end at the same place of the curve between them, which the joined curve has twice, with either normal.
#pragma once

#include "core/complexes/complex.h"
#include "core/surface/curves/section.h"

namespace complexes {

/// The longest first; the same bits at any thread count. Throws base::Cancelled.
std::vector<surface::SectionCurve> findSection(const Complex& complex, const base::Plane& plane,
                                               const base::Progress& progress = {},
                                               const surface::TraceOptions& options = {});

} // namespace complexes
