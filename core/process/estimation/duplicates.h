// Points that stand in one place: depth cameras write thousands of "0 0 0", programs write each corner once per face,
// and scans that were joined twice hold everything twice, a rounding apart (process/README 1.5).
//
// Kept, they would say nothing new and cost as much as the square of their number, because each stands in every other's
// neighbourhood. Time is linear in the points but for sorting; the result is the same at any thread count.
#pragma once

#include "core/process/neighbours/cloud_neighbours.h"

namespace process {

/// Piles of so many positions leave too few of 12 neighbours outside of themselves: they are sought as gaps.
inline constexpr std::size_t leastPile = 6;
/// How many of its 12 nearest, at these ascending squared distances, are one place with a position: those that leave a
/// gap to the ring behind them.
std::size_t duplicatesBeside(std::span<const float> distanceSq);

/// Of each point of the list that `cloud` was made of the first one that it is a duplicate of; itself where it is none.
/// Empty where no point is one. First is the one with the least of the `numbers`, its place in the list where there are
/// none.
std::vector<std::uint32_t> firstOfDuplicates(const Cloud& cloud, const CloudNeighbours& neighbours,
                                             const base::Progress& progress = {},
                                             std::span<const std::uint32_t> numbers = {});

/// Takes duplicates away and returns how many there were. The first of them stays as it is but for its normal, which
/// becomes the mean of theirs unless they cancel. `first` as above.
std::size_t mergeDuplicates(surfel::SurfelList& points, std::span<const std::uint32_t> first);

} // namespace process
