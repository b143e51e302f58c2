// Whether the sides that normals tell agree: those of a file may look out here and in beside it.
#pragma once

#include "core/tree/surfel_tree.h"

#include <cmath>

namespace process {

/// Does a neighbour that lies `way` off lie in the sheet of this unit normal: less than 17 degrees off its tangent
/// plane? The two sides of a wall do not, unless it is thinner than a third of a spacing.
inline bool inSheet(const base::Vec3f& way, const base::Vec3f& normal) {
    const float most = 0.3f * length(way); // a sine
    return most > 0 && std::abs(dot(way, normal)) <= most;
}
/// By more than 120 degrees.
inline bool lookOpposite(const base::Vec3f& a, const base::Vec3f& b) {
    return dot(a, b) < -0.5f;
}

/// Of pairs of neighbours in one sheet, how many have normals that look opposite ways; 0 to 1. What stands across a
/// thin wall is no neighbour. From up to 4096 surfels.
double contradictions(const tree::SurfelTree& tree);

} // namespace process
