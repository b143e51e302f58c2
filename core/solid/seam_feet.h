// Which surfels of two solids lie beside the seam, and where on it they have their feet (solid/README 2.3). Inside this
// room only.
#pragma once

#include "core/solid/seam.h"

#include <functional>
#include <vector>

namespace solid {

/// The foot on the seam of surfel `index`, in tree order, of one of both versions.
struct SeamFoot {
    std::size_t index;
    base::Vec3d place;
    double spacing;
    std::uint32_t cell; ///< that version's number; 0 without labels
};
using SeamFeet = std::vector<std::vector<SeamFoot>>; ///< block by block

/// Of the surfels of a version within two of their spacings of the seam (cells::partnerReach) those that `stays` tells
/// by their index, from many threads. `other`: the side that the version is cut by. Throws base::Cancelled by the
/// scope.
SeamFeet seamFeetOf(const tree::SurfelTree& version, const TwoSides& sides, const Side& other,
                    const std::function<bool(std::size_t index)>& stays);

} // namespace solid
