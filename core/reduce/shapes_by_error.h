// Shapes of a reduced set's supports: ellipses along which samples err less than discs of the same area would
// (reduce/README 3.6).
#pragma once

#include "core/reduce/places.h"

namespace reduce {

/// Gives every place the shape that supports shall have there, and takes shares from where that makes samples better;
/// together they stay `count`. Returns what the ellipses leave of the discs' error, in the mean of logarithms: 1 where
/// they gain nothing. REQUIRES: measured areas; `tree` holds the places; shares as density.h makes them. In parallel;
/// the same bits at any thread count. Throws base::Cancelled.
double shapeByError(Places& places, const NumberedTree& tree, std::vector<float>& shares, std::size_t count);

} // namespace reduce
