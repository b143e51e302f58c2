// Neighbours share what their rays found (raycast/README 4.5): each pixel of an image asks in a sixteenth of the
// directions; the mean over those pixels around it that show the same part of the surface has asked in all of them.
#pragma once

#include "core/raycast/light_points.h"

namespace raycast {

/// Replaces values by their means; does nothing for width 0. The window is 5 x 5 with a border that counts half, so
/// that each of the sixteen patterns counts the same. In parallel.
void edgeAwareFilter(std::span<const LightPoint> points, int width, std::span<float> values);

} // namespace raycast
