// Creases that have one face on both sides, because they end in it or because nobody knows where they end
// (cells/README 6.2, as 1.4): both sides become bands, cells of that face which are smooth to all of it but each other.
#pragma once

#include "core/cells/creases/surfel_links.h"
#include "core/cells/labels.h"

namespace cells {

/// Cells: of each surfel its number in `faces`, or a new one for each band, from the largest face on. Links that are
/// cut within a face are what tells its two sides.
std::vector<std::uint32_t> splitAtCreases(const SurfelLinks& links, std::span<const std::uint32_t> faces);

/// Labels of surfels whose cells were split so: partners across older creases are what these have become near by.
void moveToCells(const SurfelLinks& links, std::span<const std::uint32_t> cells, std::span<Label> labels);

} // namespace cells
