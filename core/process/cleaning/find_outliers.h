// Points that are not of the model, by four ways to tell (process/README 11.2). All compare with what is usual around a
// point, never with the whole model: densities of 1 : 20 lose nothing.
//
//     statistical    farther from its 16 nearest than they are from theirs
//     radius         too few others within 3 local spacings
//     islands        in a small piece that is connected with nothing else along the surface
//     surface        off the surface that its neighbours make without it, by more than their noise
//
// With each of them go swarms, which neighbours cannot tell apart: few sparse points about a model that nothing of the
// model sees (estimation/outliers.h).
#pragma once

#include "core/process/neighbours/knn.h"

#include <optional>

namespace process {

enum class OutlierWay { Statistical, Radius, Islands, Surface };

struct OutlierQuestion {
    OutlierWay way = OutlierWay::Statistical;
    /// What is still no outlier. Statistical, Surface: so many standard deviations (4). Radius: so many others (6, at
    /// most 16). Islands: pieces of so many points (the square root of the largest piece's).
    std::optional<double> limit;
};

/// True for each position of the cloud that is one. In parallel, the same at any thread count. Throws base::Cancelled.
std::vector<std::uint8_t> findOutliers(const Cloud& cloud, const OutlierQuestion& question,
                                       const base::Progress& progress = {});

} // namespace process
