// The naive ways to draw and to smooth: plain arrays, a radius search for what is under the brush, Eigen in double. The
// same displacement as the tools (sculpt/README); its k-d tree is left as it was. One thread.
#pragma once

#include "app/bench/naive/naive_surface.h"

namespace bench {

struct NaiveDab {
    base::Vec3f centre, normal;
    float radius = 0;
    float strength = 0.5f;
};

/// Pushes what is under the brush along the dab's normal and turns normals as the displacement bends the surface. What
/// moved goes to `out`.
void naiveDraw(const NaiveSurface& surface, const NaiveDab& dab, std::vector<surfel::Surfel>& out);

/// Draws what is under the brush to the surface that its neighbours make, which a radius search finds for each surfel.
void naiveSmooth(const NaiveSurface& surface, const NaiveDab& dab, std::vector<surfel::Surfel>& out);

} // namespace bench
