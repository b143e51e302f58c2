// Models that know where they end (surface/rims.h), and what is known of what is made of them.
#pragma once

#include "core/process/estimation/left_rims.h"

namespace process {

/// Is it known where the surface ends: because it knows its rims, or does not end?
bool endIsKnown(const surface::Surface& surface);

/// Is it left to the model where it ends, and does no attribute of that name tell of something else?
bool mayKnowRims(const surface::Surface& surface);

/// It ends at these places, so many supports about each, and nowhere else, and knows it; with none it ends nowhere,
/// and its limit is none. REQUIRES: mayKnowRims.
surface::Surface endingAt(const surface::Surface& surface, std::span<const base::Vec3d> rims,
                          float reach = reachOfLeftRims);

/// Is it known of what is put together of these, whose surfels say it?
bool knowRimsTogether(std::span<const surface::Surface* const> surfaces);

/// Surfels of several such, some of which may be gone: what they knew is true of all of them, with a limit that fits.
/// Where nothing tells of a rim any more, it may lie within another one: it ends nowhere.
surface::Surface withKnownRims(tree::SurfelTree tree, surface::SurfaceDefinition definition,
                               const base::Progress& progress = {});

} // namespace process
