// The generalised winding number of oriented surfels [Jacobson13, Barill18]: 1 inside of what they enclose, 0 outside,
// and between where they leave gaps (surface/README 11).
//
//     w(x) = 1 / 4 pi  sum a_i n_i . (p_i - x) / (|p_i - x|^2 + a_i / 4)^(3/2)
//
// a_i is the area that a surfel stands for (surfel_areas.h). Far groups of surfels count as one dipole at their centre
// of area: whole nodes, blocks and clusters of the tree. A query costs a microsecond or two, whatever the model's size.
//
// Ownership: holds what it needs by value, the tree may go. Immutable; any number of threads may ask.
#pragma once

#include "core/surface/winding/surfel_areas.h"
#include "core/surface/winding/winding_kernel.h"

namespace surface {

class WindingNumber {
  public:
    /// REQUIRES: oriented normals. Throws base::Cancelled.
    explicit WindingNumber(const tree::SurfelTree& tree, const base::Progress& progress = {},
                           Areas which = Areas::Each);

    /// Of dipoles in the order of a curve (base/morton.h): runs of them are the groups. `areas`: times the normal.
    WindingNumber(std::span<const base::Vec3f> places, std::span<const base::Vec3f> areas);

    double at(const base::Vec3d& x) const;
    /// Its derivative, in 1 / model units: points inwards.
    base::Vec3d gradient(const base::Vec3d& x) const;

  private:
    void chooseScale(const base::Box3f& box);

    std::vector<WindingGroup> m_groups;
    double m_scale = 1; ///< lengths of theirs over the model's
};

} // namespace surface
