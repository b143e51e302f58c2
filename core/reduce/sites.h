// The samples of a reduced set while it is made: numbered, by placement first, then with supports, then fitted.
#pragma once

#include "core/reduce/places.h"

namespace reduce {

struct Sites {
    std::vector<base::Vec3f> position, normal;
    std::vector<float> spacing; ///< wanted around each: the root of the area that it stands for
    std::vector<float> support;
    std::vector<base::Vec3f> shape; ///< of the support (surfel/shape.h); empty: balls

    std::size_t size() const { return position.size(); }
    base::Vec3f shapeAt(std::size_t i) const { return shape.empty() ? base::Vec3f{} : shape[i]; }
};

} // namespace reduce
