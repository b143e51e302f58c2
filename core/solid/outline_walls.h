// Surfels on the walls that an outline sweeps through a model (solid/README 3.1).
#pragma once

#include "core/solid/outline_side.h"

namespace solid {

/// As dense as the model is beside them, with the model's definition of supports, facing away from what the outline
/// holds; labelled where the outline turns sharply. They reach as deep as the model goes where walls cross it. Throws
/// base::Error where they would be more than 20 million; base::Cancelled by the scope.
surfel::SurfelList wallsOf(const OutlineSide& side, const surface::Surface& model);

} // namespace solid
