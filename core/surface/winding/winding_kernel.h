// The vectorised sum of a winding number (surface/README 11.1). Internal to the room of surfaces.
//
// Dipoles stand in groups of eight, a vector of AVX2: the children of a node or of a block, each as one dipole at its
// centre of area, or half of the surfels of a cluster. A sum begins with the topmost group; where a lane is too near to
// count as one, the groups that it stands for follow.
#pragma once

#include "core/base/vec.h"

#include <span>

namespace surface {

/// Lengths in whatever unit keeps their cubes within float32.
struct alignas(64) WindingGroup {
    static constexpr int lanes = 8;
    static constexpr std::uint32_t none = 0xffffffff;

    float x[lanes], y[lanes], z[lanes]; ///< places, from the centre on
    float areaX[lanes], areaY[lanes], areaZ[lanes];
    float softSq[lanes];        ///< what is added to squared distances
    float farSq[lanes];         ///< the squared distance beyond which a lane counts as one; below zero: anywhere
    std::uint32_t below[lanes]; ///< the first group of what it stands for
    base::Vec3f centre;
    std::uint32_t next = none; ///< another group of the same cluster
};

/// The sums of a . p / |p|^3 and its derivative, not yet over 4 pi.
double windingKernel(std::span<const WindingGroup> groups, const base::Vec3d& x);
base::Vec3d windingGradientKernel(std::span<const WindingGroup> groups, const base::Vec3d& x);

} // namespace surface
