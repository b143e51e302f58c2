// Where two models meet one may be sampled many times as coarsely as the other. Its supports then reach beyond the seam
// to where nothing of the other one is, and would stand there as crumbs of their own. So it gives way to finer samples
// on the same surface, which grow as they lie farther from the seam (solid/README 2.8). Inside this room only.
#pragma once

#include "core/base/progress.h"
#include "core/solid/seam_feet.h"
#include "core/surface/surface.h"

#include <optional>

namespace solid {

/// A version with finer samples beside the seam where it is sampled more than three times as coarsely as the other one,
/// whose feet tell where the seam is; nothing where it is not. What is as fine as is asked for keeps every bit. The
/// same bits at any thread count; throws base::Cancelled. REQUIRES: surfels, with oriented normals.
std::optional<surface::Surface> gradedBeside(const surface::Surface& version, const SeamFeet& others);

} // namespace solid
