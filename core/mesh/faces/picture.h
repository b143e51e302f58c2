// A picture laid over faces, as files name them for their materials.
#pragma once

#include "core/surfel/surfel.h"

#include <vector>

namespace mesh {

struct Picture {
    int width = 0, height = 0;
    std::vector<surfel::Colour> pixels; ///< rows from top to bottom
    bool clamped = false;               ///< beyond its border goes on the border's colour; else it repeats

    /// Bilinear between the middles of pixels; (0, 0) is the lower left corner, (1, 1) the upper right one.
    /// REQUIRES: finite u and v, at least one pixel.
    surfel::Colour at(double u, double v) const;
};

} // namespace mesh
