#include "core/sculpt/mirror.h"

namespace sculpt {

std::vector<Mirror> mirrors(const Symmetry& symmetry, const base::Vec3d& origin) {
    std::vector<Mirror> out;
    for (int k = 0; k < 8; ++k) {
        const bool x = k & 1, y = k & 2, z = k & 4;
        if ((!x || symmetry.x) && (!y || symmetry.y) && (!z || symmetry.z))
            out.push_back({x, y, z, base::cast<float>(-origin)});
    }
    return out;
}

} // namespace sculpt
