// Caps of models that are open elsewhere (solid/README 2.4): what was a rim of the model and stays is one, and nothing
// else; where the section itself is open there is no whole cap, and that is told.
#pragma once

#include "core/solid/combine.h"

namespace solid {

/// `capped`: the model after a cap was put on the side's surface. `kept`: the side that stays, 1: outside, -1: inside.
/// Where the section is closed the model knows its rims from now on (surface/rims.h), unless its limit is its own;
/// else `open` of the result is a place where a rim meets the cap. Closed models stay as they are.
Combined endingAsBefore(const surface::Surface& model, const Side& side, int kept, Combined capped,
                        const base::Progress& progress = {});

} // namespace solid
