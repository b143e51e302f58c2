// What is known of the numbers of samples of reduced sets. Internal to the room.
#pragma once

#include <cstddef>
#include <vector>

namespace reduce {

/// A surface wants some samples around every place.
constexpr std::size_t fewest = 8;
/// Errors fall with this power of the count where the surface is resolved.
constexpr double fall = 1.6;

/// Whole numbers that are together `total`, in proportion to `weights`, none below its `least` nor above its `most`.
/// REQUIRES: lists of one length, weights > 0, sum of least <= total <= sum of most.
std::vector<std::size_t> apportion(const std::vector<double>& weights, const std::vector<std::size_t>& least,
                                   const std::vector<std::size_t>& most, std::size_t total);

} // namespace reduce
