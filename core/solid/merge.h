// Parts of one model that were pushed into each other, made one solid (solid/README 4.3).
#pragma once

#include "core/solid/combine.h"
#include "core/solid/inside_others.h"

namespace solid {

/// What lies inside of another part of the model goes; what stays keeps every bit but its labels beside seams, which
/// are sharp with `creases` and else round over about a support. Throws as combine does; base::Cancelled.
Combined merged(const surface::Surface& model, bool creases = true, const base::Progress& progress = {},
                Overlaps overlaps = Overlaps::OfMatter);

} // namespace solid
