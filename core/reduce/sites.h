// The samples of a reduced set while it is made: numbered, by placement first, then with supports, then fitted.
#pragma once

#include "core/reduce/places.h"

namespace reduce {

struct Sites {
    std::vector<base::Vec3f> position, normal;
    std::vector<float> spacing; ///< wanted around each
    std::vector<float> support;

    std::size_t size() const { return position.size(); }
};

} // namespace reduce
