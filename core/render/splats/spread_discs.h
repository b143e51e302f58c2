// The finer discs that take the place of one (finer_blocks.h): how many, where, and how large (render/README 4.4). They
// lie on a hexagonal lattice about its middle, `rings` of them from there to its end.
#pragma once

#include "core/base/vec.h"

#include <vector>

namespace render {

/// How a disc is seen: lengths in pixels.
struct SeenDisc {
    float radius = 0;
    float standOut = 0; ///< over the surface
    bool ends = false;  ///< the surface does, within it
};

/// 0: small enough as it is; else 1 to `mostRings`.
int spreadRings(const SeenDisc& disc);
constexpr int mostRings = 4;

/// Of the finer discs, as a part of the one they stand for.
float spreadRadius(int rings);

/// Where their middles are, in the plane across `normal`, in radii of the disc, its own first: all that it covers and,
/// where the surface `ends` within it, what lies beyond, up to 1.7: where nothing else does, the surface goes on.
std::vector<base::Vec3f> spreadPlaces(const base::Vec3f& normal, int rings, bool ends);
/// Half a step towards the middle from one of them.
base::Vec3f fartherIn(const base::Vec3f& place, int rings);

} // namespace render
