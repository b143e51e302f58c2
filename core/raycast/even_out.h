// Neighbours share what their rays found: each pixel of an image asks into a sixteenth of the directions, and the mean
// over the 4 x 4 pixels around it that show the same part of the surface has asked into all of them.
#pragma once

#include "core/raycast/places.h"

namespace raycast {

/// Means in place; nothing for width 0. Weights are those of a 5 x 5 window whose rim counts half, so that each of the
/// sixteen patterns counts the same. In parallel.
void evenOut(std::span<const Place> places, int width, std::span<float> values);

} // namespace raycast
