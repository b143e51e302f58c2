// Relaxed placement of a reduced set: Lloyd's rounds among the places, by a density (reduce/README 3.3).
//
//     shares      how much of a sample falls to each place                  density.h
//     start       darts that keep each other off
//     rounds      each place goes to its site; each site to the middle of what came
//     end         sites land on the dense surface
#pragma once

#include "core/reduce/sites.h"

namespace reduce {

/// `count` sites on the surface that the places are of; no supports yet. `tree` holds the places. REQUIRES: count <=
/// places. In parallel; the same bits at any thread count. Throws base::Cancelled.
Sites place(const surface::Surface& surface, const Places& places, NumberedTree tree, std::span<const float> shares,
            std::size_t count, const base::Progress& progress = {});

} // namespace reduce
