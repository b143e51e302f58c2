// The shortest way along a surface between two places, and how long it is (process/README 12.3).
//
//     walks.h           ways from surfel to surfel, one around each side of what lies between
//     straighten.h      each drawn tight on the surface itself; the shortest is it
//
// The length is that of the surface that the points define, whatever their density: walks only tell on which side of
// what it passes.
#pragma once

#include "core/process/measuring/straighten.h"

namespace process {

/// `from` and `to` are places near the surface; the way begins and ends at their feet. The same bits at any thread
/// count. Throws base::Error where a place has no foot, or no way along the surface leads from one to the other,
/// base::Cancelled.
Geodesic geodesic(const surface::Surface& surface, const base::Vec3d& from, const base::Vec3d& to,
                  const base::Progress& progress = {});

/// The place of the surface nearest to x: its foot, or that of the nearest surfel. Throws base::Error where there is
/// none.
GeodesicPoint footOf(const surface::Surface& surface, const base::Vec3d& x);

} // namespace process
