// Patches of earlier views drawn into a new one, as free samples of its lattice (alg. 4.3, object space).
//
// A patch is drawn as small squares with a depth buffer, unless the view shows its other side, shows it at a flat
// angle, or magnifies it: the interior of a leaf is good at any size up to four times, what was still bent at the last
// level is not. Pixels that a disc of the guard stands before are left open.
#pragma once

#include "core/raycast/kept_patches.h"

namespace raycast {

/// Writes open pixels of the lattice and their samples in `picture`; patches that are not good enough for `quality`
/// are left out. Returns a number for each patch, not 0 where it shows. In parallel, the same at any thread count.
std::vector<std::uint8_t> redraw(const KeptPatches& patches, const CastView& view, double quality,
                                 AdaptivePicture& picture);

} // namespace raycast
