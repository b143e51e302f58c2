// All boundary curves of a model (surface/README 5.3): points are looked for near every surfel whose off-centre value
// is that of a boundary, and the curves through them are traced once each.
//
// The same bits at any thread count: seeds are found in parallel, curves are traced in tree order.
#pragma once

#include "core/base/progress.h"
#include "core/surface/curves/boundary.h"

namespace surface {

/// Longest first; none where the definition's limit is infinite. Throws base::Cancelled.
std::vector<BoundaryCurve> findBoundaryCurves(const Surface& surface, const base::Progress& progress = {},
                                              const TraceOptions& options = {});

} // namespace surface
