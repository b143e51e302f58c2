// Piles: positions so close together, beside what is around them, that they may be one place. They are the ranges of a
// tree that halves positions by the boxes that they fill, where a range's own box is at most 1/64 of the one around it
// and something else (process/README 1.5). Whether they are one place is decided elsewhere (duplicates.h).
#pragma once

#include "core/process/neighbours/knn.h"

namespace process {

struct Pile {
    std::vector<std::uint32_t> members; ///< at least leastPile (duplicates.h)
    float extent = 0;                   ///< diagonal of their box
};

/// Those of a whole cloud. `closestPile` tells, cell by cell, how close the closest stand in it (cloud_neighbours.h):
/// where that is too far for a pile nothing is cut, so that most models cost a look at their cells.
std::vector<Pile> findPiles(const Cloud& cloud, std::span<const float> closestPile, const base::Progress& progress);

/// Those inside of a pile.
void findPiles(std::span<const base::Vec3f> positions, const Pile& within, const base::Progress& progress,
               std::vector<Pile>& out);

} // namespace process
