// The way back from a reduced set: dense samples at any spacing on the surface that a few define (reduce/README 7).
#pragma once

#include "core/reduce/verify.h"

namespace reduce {

struct Refined {
    surface::Surface surface;
    Report report; ///< the model given, seen as the dense one, at places all over its surface; rms and so on of those
};

/// Samples with that spacing, evenly spread over the surface, with supports of the default number of neighbours.
/// Colours, masks and attributes are weighted means. In parallel, the same bits at any thread count. Throws base::Error
/// for curves and for a spacing that is not positive or would make more surfels than fit; base::Cancelled.
Refined refine(const surface::Surface& model, float spacing, const base::Progress& progress = {});

/// One sentence about a refined model, and how far it is from `what`.
std::string refinedSummaryOf(const Report& report, const std::string& what);

} // namespace reduce
