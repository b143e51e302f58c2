// Draws patches of earlier views into a new one, as free samples of its lattice (raycast/README 3.2).
//
// A patch is drawn as small squares with a depth buffer, unless the view shows its other side, shows it at a grazing
// angle, or magnifies it too much: leaves may grow to four times their size, cells that were still bent at the last
// level may not. Pixels that are behind a disc of the guard stay open.
#pragma once

#include "core/raycast/kept_patches.h"

namespace raycast {

/// Writes open pixels of the lattice and their samples in `picture`; leaves out patches that are not good enough for
/// `quality`. Returns a number for each patch, not 0 where it shows. In parallel, the same at any thread count.
std::vector<std::uint8_t> redraw(const KeptPatches& patches, const CastView& view, double quality,
                                 AdaptivePicture& picture);

} // namespace raycast
