// Rays of one view in an order in which neighbours in the list are neighbours in the view, whatever order they come in:
// a row of pixels shares less of the surface than a tile of them. Internal to the room.
#pragma once

#include "core/base/box.h"
#include "core/base/ray.h"

#include <cstdint>
#include <span>
#include <vector>

namespace surface {

/// Do the rays run about one way, as those of a picture do? REQUIRES: some.
bool oneView(std::span<const base::Rayf> rays);

/// Indices of the rays along a Morton curve through the places where they enter `bounds`. Empty where that would not
/// pay: few rays, rays that are in such an order already, or that run all ways.
std::vector<std::uint32_t> viewOrder(std::span<const base::Rayf> rays, const base::Box3f& bounds);

} // namespace surface
