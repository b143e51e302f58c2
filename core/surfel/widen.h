// A list of surfels under a layout with more attributes than it had.
#pragma once

#include "core/surfel/surfel.h"

namespace surfel {

/// Gives the list a layout whose first words are its own; the further ones are 0.
void widen(SurfelList& list, AttributeLayoutPtr layout);

} // namespace surfel
