// The boundary loops of a model, for what works on them by number. Inside this room only.
#pragma once

#include "core/base/error.h"
#include "core/surface/curves/boundary_curves.h"
#include "core/surface/definition_text.h"

namespace solid {

/// Longest first. Throws base::Error in the name of `who` for what is no surface ("a curve " + `lacks`) and for
/// surfaces that have no boundary limit; base::Cancelled.
inline std::vector<surface::BoundaryCurve> openLoops(const surface::Surface& surface, const char* who,
                                                     const std::string& lacks, const base::Progress& progress) {
    if (surface.definition().manifold != surface::Manifold::Surface)
        throw base::Error(surface::nounOf(surface.definition().manifold) + " " + lacks, who,
                          "open the model as a surface");
    if (!std::isfinite(surface.definition().boundaryLimit))
        throw base::Error("the surface has no boundary: it is closed, or its boundary limit is none", who,
                          "give it a limit, 0.25 for example, if it has holes");
    return findBoundaryCurves(surface, progress);
}

/// "there are 4 boundary loops"
inline std::string thereAreLoops(std::size_t count) {
    return count == 1 ? "there is 1 boundary loop" : "there are " + std::to_string(count) + " boundary loops";
}

/// Throws base::Error in the name of `who` where no loop of so many has that number.
inline void requireLoop(std::size_t number, std::size_t count, const char* who) {
    if (number >= count)
        throw base::Error("there is no boundary loop number " + std::to_string(number), who,
                          std::to_string(count) + " were found; they count from 0");
}

} // namespace solid
