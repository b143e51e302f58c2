// The fit of a reduced set to the dense surface: offsets along normals and tilts of normals, so that f vanishes at the
// places (reduce/README 4). Gauss-Newton rounds; each round's sparse least squares are solved by conjugate gradients.
#pragma once

#include "core/reduce/sites.h"

namespace reduce {

/// Moves and tilts the sites; supports stay. In parallel; the same bits at any thread count. Throws base::Cancelled.
void fit(const Places& places, Sites& sites, const base::Progress& progress = {});

/// After others moved the marked sites along the surface: offsets and tilts of these anew. REQUIRES: a mark for each.
void fitAgain(const Places& places, std::span<const std::uint8_t> marked, Sites& sites,
              const base::Progress& progress = {});

} // namespace reduce
