// The least that a renderer of splats can do. One thread.
#pragma once

#include "core/render/renderer.h"
#include "core/surfel/surfel.h"

#include <span>

namespace bench {

/// Every surfel as a square of its splat's size, `radiusOfSupport` h; the nearest wins the pixel, lit by its own
/// normal: nothing is blended.
void naiveSplats(std::span<const surfel::Surfel> surfels, float radiusOfSupport, const render::Camera& camera,
                 render::Image& image);

} // namespace bench
