// Where a complex ends: the curves that bound one patch alone, joined end to end.
#pragma once

#include "core/base/progress.h"
#include "core/complexes/complex.h"
#include "core/surface/curves/boundary.h"

namespace complexes {

/// The longest first. Where more than two such curves meet in a point, a loop goes on along the patch that it is on.
/// Corners are there twice, with what either curve says of them. Throws base::Cancelled.
std::vector<surface::BoundaryCurve> findRims(const Complex& complex, const base::Progress& progress = {});

} // namespace complexes
