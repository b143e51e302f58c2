// Where a model's surface ends, as far as the model knows (surface/README 5.4).
//
// The limit of off-centre values tells rims from the points alone. It takes tips, blades and folds for rims as well,
// for there surfels lie to one side, too. A model made of faces knows better: its surfels carry the attribute
//
//     rim        integer   1 where a rim of the surface is within half of the surfel's support, else 0
//
// and its surface ends by the limit only where such a surfel is the nearest. Models without the attribute end wherever
// the limit is passed. Any number of threads may ask.
#pragma once

#include "core/surface/surface.h"

#include <cmath>
#include <optional>

namespace surface {

inline constexpr const char* rimName = "rim";
constexpr float rimReach = 0.5f; ///< of a support: how near a rim is to a surfel that tells of it

/// The channel of blocks that tells of rims, where there is one.
std::optional<int> rimChannel(const surfel::AttributeLayout& layout);

/// Does the model know its rims? They are an attribute and a word of the definition: who lets surfels go, or joins
/// models, takes the word back.
inline bool knowsRims(const Surface& surface) {
    return surface.definition().knownRims && rimChannel(*surface.tree().layout());
}

/// Does any surfel tell of a rim?
bool hasRim(const tree::SurfelTree& tree);

/// Does this one, by the channel of rims?
inline bool tellsOfRim(const surfel::SurfelBlock& block, int slot, int channel) {
    return block.words(slot / surfel::clusterSize, channel)[slot % surfel::clusterSize] != 0;
}

/// Does this one?
bool isBesideRim(const surfel::SurfelBlock& block, int slot, const surfel::AttributeLayout& layout);

/// Whether the surface may end at x: everywhere, but where the model knows its rims and the nearest surfel none.
template <class T>
bool mayEnd(const Surface& surface, const base::Vec3<T>& x);

/// Is x, so far off centre, past the surface's end?
template <class T>
bool isPastEnd(const Surface& surface, const base::Vec3<T>& x, T offCentre, T unit) {
    const float limit = surface.definition().boundaryLimit;
    return offCentre > static_cast<T>(limit) * unit && std::isfinite(limit) && mayEnd(surface, x);
}

} // namespace surface
