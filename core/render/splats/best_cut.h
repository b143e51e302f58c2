// Which code suits a disc best that ends at several lines, as at corners and on narrow faces (render/README 3.2): one
// line with what is left of the radius, or two. Lines are exact here, and codes are not.
#pragma once

#include "core/render/splats/disc_cuts.h"

#include <span>

namespace render {

/// Ends the disc at a line, however many parts of its radius off; not above 0 where its middle lies beyond.
CutCode oneCut(const base::Vec3f& normal, const CutLine& at, Beside beside);

/// The code that is least wrong at 128 places of the disc. At least one line, the one that matters most first.
CutCode bestCut(const base::Vec3f& normal, float support, std::span<const CutLine> lines);

} // namespace render
