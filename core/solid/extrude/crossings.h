// Whether what is drawn out runs through the model on its way (solid/README 4.4). Inside this room only.
#pragma once

#include "core/base/progress.h"
#include "core/solid/loops/loop.h"
#include "core/surface/surface.h"

namespace solid {

/// A part of a model that moves away from the rest by `way`, and the borders between both from which walls follow it.
struct Drawn {
    surface::Surface part, rest; ///< where they are before; they end at the borders
    std::vector<Loop> borders;
    std::vector<std::vector<std::uint8_t>> stands; ///< of each border's places, where there is a wall
    base::Vec3d way;
};

/// Rays that say so, of all that were sent.
struct Crossings {
    std::size_t rays = 0, of = 0;
    base::Vec3d place; ///< the first of them
};

/// By exact rays along the whole way: from the part's surfels to the rest, from the borders to the rest and, as what
/// has moved meets a wall, back to the part; and by whether walls lie on the rest. Pits and ridges that keep clear meet
/// nothing, however narrow. In parallel. Throws base::Cancelled.
Crossings crossingsOf(const Drawn& drawn, const base::Progress& progress = {});

/// Likewise of a wall along a loop, `ways` from its places.
Crossings crossingsOf(const surface::Surface& surface, const Loop& loop, std::span<const base::Vec3d> ways);

} // namespace solid
