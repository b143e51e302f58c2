// How densely a reduced set samples each part of a surface: by the error that samples of that size would make there
// (reduce/README 3.1, 3.2). Relative to the dense sampling around, nowhere to the whole model.
#pragma once

#include "core/reduce/places.h"

namespace reduce {

/// Of each place the part of a reduced sample that falls to it, at most 1; together they are `count`, or as many as the
/// places can bear. REQUIRES: measured areas; `tree` holds the places. In parallel; the same bits at any thread count.
std::vector<float> sharesByError(const Places& places, const NumberedTree& tree, std::size_t count);

/// One factor for all, so that together they are `count`, or as many as the places can bear.
void scaleShares(std::vector<float>& shares, std::size_t count);

/// Likewise for an even spacing; as many samples as it makes.
std::vector<float> sharesBySpacing(const Places& places, float spacing);

/// The spacing of reduced samples at a place.
inline float spacingAt(const Places& places, std::span<const float> shares, std::size_t i) {
    return std::sqrt(places.area[i] / shares[i]);
}

} // namespace reduce
