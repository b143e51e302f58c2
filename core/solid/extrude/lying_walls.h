// Walls that lie on the model and face it, as where a whole face is pushed in between its neighbours: neither bounds
// anything (solid/README 4.4). Inside this room only.
#pragma once

#include "core/solid/extrude/part.h"

namespace solid {

/// Takes such surfels out of `walls`, and what they lie on, in tree order of the model, into `covered`: of `part` none.
/// `rest`: what is beside it.
void takeLying(const surface::Surface& surface, const Part& part, const tree::SurfelTree& rest,
               surfel::SurfelList& walls, std::vector<std::uint8_t>& covered);

} // namespace solid
