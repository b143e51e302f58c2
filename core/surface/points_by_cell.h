// Which points sample which cell of a complex (connectivity.h): the numbers beside them, checked.
#pragma once

#include "core/surface/connectivity.h"
#include "core/surfel/surfel.h"

#include <cstddef>

namespace surface {

/// Of each of `cells` cells the numbers of its points, rising. Throws base::Error where the points have no numbers of
/// cells, or one is none of these.
std::vector<std::vector<std::uint32_t>> pointsByCell(const surfel::SurfelList& points, std::size_t cells);

} // namespace surface
