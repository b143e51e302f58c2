#include "core/cells/creases/fade_creases.h"

#include "core/base/parallel.h"
#include "core/cells/creases/labelled_surface.h"

#include <algorithm>

namespace cells {

surface::Surface fadeCreases(const surface::Surface& surface, const std::function<double(const base::Vec3f&)>& share) {
    if (!LabelLayout::of(*surface.tree().layout()))
        return surface;
    surfel::SurfelList surfels = surface.tree().surfels();
    std::vector<Label> labels = labelsOf(surface.tree());
    std::vector<std::uint8_t> faded(labels.size(), 0);
    base::parallelFor(labels.size(), 1024, [&](std::size_t i) {
        if (labels[i].meeting == Meeting::None)
            return;
        const double left = 1 - std::clamp(share(surfels.items[i].position), 0.0, 1.0);
        const auto sharpness = static_cast<std::uint8_t>(std::lround(left * labels[i].sharpness));
        faded[i] = sharpness < labels[i].sharpness ? 1 : 0;
        labels[i].sharpness = sharpness;
    });
    if (std::count(faded.begin(), faded.end(), 1) == 0)
        return surface;
    return labelled(surface, std::move(surfels), labels);
}

} // namespace cells
