// What is left beside surfels that went has a rim there, in models that know their rims (surface/rims.h).
#pragma once

#include "core/surface/surface.h"

namespace process {

/// Supports, from what went or from the curve where the surface ends. Farther than surface::rimReach: the last row is
/// .14 before the edge of its area and ragged by as much again and more, and limits draw curves up to .33 beyond that
/// edge.
constexpr float reachOfLeftRims = 0.8F;

/// Of `left`, a version before or after surfels went from the places `gone`: the same with the attribute `rim` on all
/// within so many supports of these. Empty where nothing changes. REQUIRES: surface::knowsRims(left).
tree::Edit rimsBeside(const surface::Surface& left, std::span<const base::Vec3f> gone);

/// The same blocks with an attribute of the name of rims: 0 everywhere, where there was none.
tree::SurfelTree withRimAttribute(const tree::SurfelTree& tree);

/// Adds them to an edit of `version` that takes surfels away and changes none; models that do not know their rims stay
/// as they are.
void addRims(const surface::Surface& version, tree::Edit& edit);

} // namespace process
