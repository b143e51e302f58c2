// A solid made hollow: an inner wall at one thickness below the surface (solid/README 4.2).
#pragma once

#include "core/solid/combine.h"

namespace solid {

/// The model with a second wall, facing inwards, `thickness` below the first, wherever there is room for one: inside
/// parts thinner than twice that stay solid. The inner wall is as dense as the outer one. Holes through it: `combine`
/// with a cylinder. Throws base::Error where no place is deep enough, and as combine does; base::Cancelled.
Combined hollowed(const surface::Surface& model, double thickness, const base::Progress& progress = {});

} // namespace solid
