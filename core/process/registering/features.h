// What the surface looks like around a place, in 33 numbers that do not depend on where it is or how it is turned:
// fast point feature histograms [Rusu09] over an even choice of a model's points. nanoflann finds alike ones behind
// this header.
#pragma once

#include "core/base/progress.h"
#include "core/surface/surface.h"

#include <array>

namespace process {

using Feature = std::array<float, 33>;

/// An even choice of a model's surfels, with their features.
struct Features {
    std::vector<base::Vec3d> position, normal;
    std::vector<Feature> feature;
    bool oriented = false;
};

/// Points no closer than `spacing`, looked at as far as 5 of it around. In parallel, the same bits at any thread count.
Features featuresOf(const surface::Surface& surface, float spacing, const base::Progress& progress = {});

/// Of each of `from` the place in `to` that is most alike. REQUIRES: `to` has some.
std::vector<std::uint32_t> mostAlike(const Features& from, const Features& to);

} // namespace process
