// Cells whose common crease has become flat all along are one again (cells/README 1.6).
#pragma once

#include "core/cells/measured_labels.h"

namespace cells {

/// An edit of the version in which the smaller one of two cells that meet in the balls, and turn by less than 8 degrees
/// wherever they meet, has the label of the other; empty where there are none, and for models without cells. Where both
/// are of one face their crease was drawn, and waits for the strokes that raise it.
tree::Edit mergedFlatPairs(const surface::Surface& surface, std::span<const EditedBall> balls);

} // namespace cells
