// Samples beside the rims of an open surface, so placed and sized that it ends where the dense one does (reduce/README
// 4.4): o = L h at the dense rims, by moves along the surface and sizes; then offsets and tilts to the places again.
#pragma once

#include "core/reduce/sites.h"

namespace reduce {

/// Points along the curves where a surface ends, in their order, with the surface's normals and, along it, the ways
/// away from it.
struct Rims {
    std::vector<base::Vec3f> position, normal, outward;
    std::vector<std::uint32_t> ends; ///< of each curve, into the points
    bool empty() const { return position.empty(); }
};

/// A place of the surface beside a rim is lost with as much o / h: limits of fitted rims end at .3, less what is slack
/// (assemble.cpp).
constexpr float lostAtRims = 0.294F;

/// Of a surface whose limit is finite; none else. In parallel; the same bits at any thread count. Throws
/// base::Cancelled.
Rims rimsOf(const surface::Surface& surface, const base::Progress& progress = {});

/// Supports of samples beside rims are to be balls: what ellipses beside each other have for o and h is uneven.
/// `shares` of the places: how many samples there shall be.
void roundBesideRims(const Rims& rims, std::span<const float> shares, Places& places);

/// Those of the places that any site is over that is over a rim.
Places placesBeside(const Rims& rims, const Places& places, const Sites& sites);

/// Sites from `begin` to `end` that were fitted to these places.
struct FittedPart {
    std::size_t begin, end;
    const Places* places;
};

/// Moves the sites of the parts; others stay. The limit that the surface ends by: L. In parallel; the same bits at any
/// thread count. Throws base::Cancelled. REQUIRES: there are rims; parts ascend.
float fitRims(const Rims& rims, std::span<const FittedPart> parts, bool oriented, Sites& sites,
              const base::Progress& progress = {});

} // namespace reduce
