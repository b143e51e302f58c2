// Points that a scanner measured half on the near and half on the far side of an edge in depth: the beam met both, the
// range is neither's. They hang as strings and veils along the line of sight (process/README 11.2).
//
// Seen from the scanner a point has neighbours on all sides, whatever their depth (eye_view.h). A mixed pixel stands
// well behind those on one side and well before those of the opposite one, it is on a bridge of a few beams with flat
// ground at both ends, and no plane through it holds much of what is around it. Floors at a flat angle are no short
// bridges, rims of balls grow steep by and by, and nothing is nearer than a wire.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

namespace process {

/// Where scanners stood, and which of them measured each point.
struct Eyes {
    std::vector<base::Vec3d> places;
    std::vector<std::uint32_t> of; ///< one per point; empty: the first one measured all
};

struct MixedQuestion {
    double limit = 2; ///< steps in depth count from so many distances between neighbouring beams on
};

/// True for each point of the list that is one. In parallel, the same at any thread count. REQUIRES: an eye. Throws
/// base::Cancelled.
std::vector<std::uint8_t> findMixedPixels(const surfel::SurfelList& points, const Eyes& eyes,
                                          const MixedQuestion& question = {}, const base::Progress& progress = {});

} // namespace process
