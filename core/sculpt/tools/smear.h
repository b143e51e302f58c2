// Smear: drags colours in the direction of the stroke.
//
//     colour'(p) = colour(p) + |strength| w(|p - centre| / R) (1 - mask) (C(p - m) - colour(p))
//
// m is the dab's own movement along the surface (along_surface.h), C the average of the colours around a place,
// weighted as the surface weighs its surfels (surface/README 2.1), over those that face as p does. Inverted, m points
// back. Nothing moves; a model without colours stays as it is.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow smearTool;

} // namespace sculpt
