// Labels after an edit (cells/README 1.6): which cell is across the nearest crease, and how both meet, follows from
// where surfels are now.
#pragma once

#include "core/cells/labels.h"
#include "core/surface/surface.h"

#include <span>

namespace cells {

/// Where something has changed.
struct EditedBall {
    base::Vec3f centre;
    float radius = 0;
};

/// Kept: surfels keep their partners, and only how both cells meet is measured, where they do not lie flat; for shapes
/// that come and go, as those of layers do.
enum class Partners { Measured, Kept };

/// New partners and signs of the surfels in any of the balls and within their supports of them, as an edit of the
/// version; empty where nothing is other than it was, and for models without cells. Cells, sharpness and faces stay.
/// In parallel, the same at any thread count.
tree::Edit measuredLabels(const surface::Surface& surface, std::span<const EditedBall> balls,
                          Partners partners = Partners::Measured);

} // namespace cells
