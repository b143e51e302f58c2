// Puts the smallest items of a range in front: quickselect (Hoare 1961) without unpredictable branches.
//
// Internal to the tree. The order (coordinate, source) is total, so that the set in front is the same however the
// selection proceeds; the order within both parts is not specified.
#pragma once

#include "core/tree/cutting.h"

namespace tree {

/// After the call the first `middle` items are the smallest along `axis`.
void selectSmallest(std::span<CutItem> items, std::size_t middle, std::size_t axis);

} // namespace tree
