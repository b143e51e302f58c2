#include "core/process/estimation/spacing.h"

#include "core/base/ranked.h"
#include "core/process/estimation/cloud_spacing.h"
#include "core/process/estimation/part_progress.h"
#include "core/process/estimation/spacing_sample.h"

#include <algorithm>

namespace process {

std::vector<float> spacingsOf(const Cloud& cloud, const base::Progress& progress) {
    std::vector<float> out(cloud.size());
    cloud.forEach(6, progress, "Measuring spacing",
                  [&](std::size_t i, const Neighbours& near) { out[i] = spacingFromRing(near.distanceSq); });
    return out;
}

std::vector<float> spacings(std::span<const surfel::Surfel> points, const base::Progress& progress) {
    const Cloud cloud(points, part(progress, 0, 0.3));
    const std::vector<float> at = spacingsOf(cloud, part(progress, 0.3, 1));
    std::vector<float> out(points.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = at[cloud.places()[i]];
    return out;
}

Summary summarise(std::vector<float> values) {
    if (values.empty())
        return {};
    const auto [least, most] = std::ranges::minmax(values);
    return {least, base::median(values), most};
}

} // namespace process
