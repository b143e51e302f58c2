// Supports of a reduced set: as many over every place as the surface needs (reduce/README 3.5).
#pragma once

#include "core/reduce/sites.h"

namespace reduce {

/// Supports over a point that a reduced set aims at.
constexpr float supportsOver = 8;

/// h = s sqrt(K / pi); then the nearest sites grow until every place has enough above it. In parallel; the same bits at
/// any thread count. Throws base::Cancelled.
void cover(const Places& places, float supports, Sites& sites);

/// Places where the surface is missed although something should be there: the sites around them grow a little, or give
/// way where there are many over them already, and projections find no end among their sheets. False where none could.
/// `supports`: over each of the places.
bool mendAround(std::span<const base::Vec3f> missed, std::span<const base::Vec3f> normals,
                std::span<const int> supports, bool oriented, Sites& sites);

} // namespace reduce
