// Borders that run along sharp edges, laid onto these (solid/README 4.4): corners of boundary curves are round, those
// of edges are not. Inside this room only.
#pragma once

#include "core/cells/seam_lines.h"
#include "core/solid/loops/loop.h"

namespace solid {

/// Places within 1.2 spacings of a line come onto it; where one goes over from one line to the next at their common
/// end a place more is that corner.
void layOnto(std::span<const cells::SeamLine> lines, Loop& loop);

} // namespace solid
