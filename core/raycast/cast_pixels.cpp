#include "core/raycast/cast_pixels.h"

#include "core/base/parallel.h"

#include <cassert>

namespace raycast {

/// Like the rays of a full cast they begin behind the planes, and hit nothing beyond the part that is kept.
void castPixels(const surface::Surface& surface, const ImageRays& view, std::span<const Pixel> pixels,
                std::span<Sample> out) {
    assert(pixels.size() == out.size());
    std::vector<std::size_t> kept;
    std::vector<base::RayPart> parts;
    std::vector<base::Rayf> rays;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const base::Rayd ray = view.ray(pixels[i].column, pixels[i].row);
        const base::RayPart part = keptPart(ray, view.clips);
        out[i] = {};
        if (part.empty())
            continue;
        kept.push_back(i);
        parts.push_back(part);
        rays.push_back({base::cast<float>(ray.at(part.first)), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> hits(rays.size());
    surface::intersect(surface, rays, {}, hits);
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    base::parallelFor(kept.size(), 256, [&](std::size_t i) {
        Sample& sample = out[kept[i]];
        sample.hit = hits[i];
        const double t = static_cast<double>(hits[i].t) + parts[i].first;
        sample.hit.t = static_cast<float>(t);
        sample.hit.hit = hits[i].hit && t <= parts[i].second;
        if (sample.hit.hit && (layout.colours || layout.masks))
            blendAttributes(surface, hits[i].position, sample);
    });
}

} // namespace raycast
