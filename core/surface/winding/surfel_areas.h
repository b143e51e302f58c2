// How much of the surface each surfel stands for (surface/README 11.2): what sums over surfels need to be integrals.
//
// From the surfels' own neighbourhood, not from the supports, which follow the spacing only roughly and not at all
// where one is given for all. Copies of a surfel share what one would have; a stray surfel, with next to nothing around
// it, stands for nothing.
#pragma once

#include "core/base/progress.h"
#include "core/tree/surfel_tree.h"

namespace surface {

/// Few: measured at two surfels of each cluster only, whose others have the same part of their supports squared; for
/// sums that an error of a few in a hundred does not hurt, in a seventh of the time. Sheet: what faces another way by
/// more than 12 to 30 degrees does not share, so that sheets that go through each other have all of their area, and
/// surfels beside edges more than theirs.
enum class Areas { Each, Few, Sheet };

/// In tree order, in model units squared. In parallel, the same bits at any thread count. REQUIRES: oriented normals.
/// Throws base::Cancelled.
std::vector<float> surfelAreas(const tree::SurfelTree& tree, const base::Progress& progress = {},
                               Areas which = Areas::Each);

} // namespace surface
