// Smooth: draws every surfel to the locally averaged surface, along that surface's gradient.
//
//     p' = p - t f(p) g / |g|^2        n' = normalise((1 - t) n + t g / |g|)        t = strength * w(|p - centre| / R)
//
// f is the model's own implicit function in the shrink-free form (surface/README 2.6, mu = 1/2), g its gradient: f(p)
// is how far p stands off the surface that its neighbours make. That form has no pull towards the centre of curvature,
// so that round shapes keep their size (a plain average loses 5/72 h^2 of curvature each time); relief shorter than
// about twice the support h goes, longer relief stays. Nothing moves sideways: spacing and open borders are as they
// were. Measured: of waves 4, 6, 8, 12 and 20 spacings long, ten full dabs leave 0.04, 0.48, 0.78, 0.95 and 0.99 (h
// = 3.5 s). Where cells meet each is drawn to its own surface (own_cells.h): edges stay, unless their sharpness fades.
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow smoothTool;

} // namespace sculpt
