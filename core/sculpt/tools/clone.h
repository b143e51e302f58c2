// Clone: copies the relief of another place of the model to where the brush works; inverted, its negative.
//
//     p' = p + |strength| w(|p - centre| / R) r N,   r = (+-h(q) - z(p)) fade(h) fade(z),   q = place of p - centre in
//                                                                                              the source
//
// z is the height of p over the base plane here, h that of the surface at the source over its base plane there. A base
// plane is the mean (position and normal) of the ring from 0.7 R to R around a place, so that what is copied is relief
// narrower than the brush, on whatever shape carries it. All of the source is taken from the version on which the
// stroke began: the exact hit of a ray along the source's base normal. Relief that is not yet there comes once: passing
// again changes nothing more.
//
// The source lies at the stroke's first contact plus (x, y, z), and follows the brush: the way from the first contact
// to this dab is turned by the smallest rotation that takes one base normal to the other, and set on the surface.
// Where the source has no surface, nothing changes; heights over 0.35 R fade, and beyond 0.7 R they are another part of
// the model and no relief.
//
//     F = I + N g^T,   g = |strength| (r grad w + w grad r),   grad h from the hit's own normal, grad z = N
#pragma once

#include "core/sculpt/tool.h"

namespace sculpt {

extern const ToolRow cloneTool;

} // namespace sculpt
