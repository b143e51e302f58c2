// The spacing of a tree, sampled: for code that needs it roughly and at once, such as the size of splats. All measures
// of spacing come from the same ring of neighbours (spacing.h).
#pragma once

#include "core/tree/surfel_tree.h"

namespace process {

/// The spacing (process/README 1.1) where the nearest other positions are at these squared distances, ascending: 0.93 x
/// the mean of the first six above zero; 0 where there are none.
float spacingFromRing(std::span<const float> distancesSq);

/// The spacing at a position of a surfel; 0 where it is alone. Cost: one search.
float spacingAround(const tree::SurfelTree& tree, const base::Vec3f& x);

/// One surfel that was looked at; of an ellipsoid the support is that of the ball of the same area.
struct SpacingSample {
    float spacing = 0, support = 0;
};

/// Some 256 surfels spread evenly through the tree, in tree order; none for fewer than 7 surfels. Cost: their searches.
std::vector<SpacingSample> sampleSpacing(const tree::SurfelTree& tree);

/// Their median spacing; 0 where there are none.
float typicalSpacing(const tree::SurfelTree& tree);

} // namespace process
