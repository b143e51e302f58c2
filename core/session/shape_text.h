// Shapes that were found in points, as messages tell them.
#pragma once

#include "core/process/measuring/detect_shapes.h"

#include <string>

namespace session {

/// "cylinder of 1200 points about 1.00 0.00 2.00 along 0 0 1, radius 0.25, rms 0.0003". `origin`: of the file;
/// `size`: the model's, to a ten-thousandth of which places are told.
std::string sentenceOf(const process::DetectedShape& shape, const base::Vec3d& origin, double size);

} // namespace session
