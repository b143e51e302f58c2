// Sample spacing: s_i = 0.93 x mean distance to the 6 nearest other positions (process/README 1.1), exact for hexagonal
// layouts. Coincident points count once, so that duplicates do not make it zero.
#pragma once

#include "core/base/progress.h"
#include "core/surfel/surfel.h"

namespace process {

std::vector<float> spacings(std::span<const surfel::Surfel> points, const base::Progress& progress = {});

struct Summary {
    float min = 0, median = 0, max = 0;
};
/// Of any values; zeros for none.
Summary summarise(std::vector<float> values);

} // namespace process
