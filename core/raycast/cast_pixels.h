// Casts the rays of chosen pixels: what fullCast finds there, bit for bit.
#pragma once

#include "core/base/parallel.h"
#include "core/cells/any_surface.h"
#include "core/raycast/full_cast.h"

namespace raycast {

/// A pixel of the image or beside it, where columns and rows go on.
struct Pixel {
    int column = 0, row = 0;
    bool operator==(const Pixel&) const = default;
};

/// In parallel, best when neighbours in the list are neighbours in the image. REQUIRES: pixels.size() == out.size().
void castPixels(const cells::AnySurface& surface, const ImageRays& view, std::span<const Pixel> pixels,
                std::span<Sample> out);

/// The same for samples that stand anywhere: of pixels[i] it is sampleAt(i), which is empty before and stays so where
/// the planes leave nothing of the ray. Rays begin behind the planes, and hit nothing beyond the part that is kept.
template <class SampleAt>
void castEach(const cells::AnySurface& surface, const ImageRays& view, std::span<const Pixel> pixels,
              const SampleAt& sampleAt) {
    std::vector<std::size_t> kept;
    std::vector<base::RayPart> parts;
    std::vector<base::Rayf> rays;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const base::Rayd ray = view.ray(pixels[i].column, pixels[i].row);
        const base::RayPart part = keptPart(ray, view.clips);
        if (part.empty())
            continue;
        kept.push_back(i);
        parts.push_back(part);
        rays.push_back({base::cast<float>(ray.at(part.first)), base::cast<float>(ray.direction)});
    }
    std::vector<surface::RayHit<float>> hits(rays.size());
    intersect(surface, rays, {}, hits);
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    const bool attributes = layout.colours || layout.masks;
    base::parallelFor(kept.size(), 256, [&](std::size_t i) {
        Sample& sample = sampleAt(kept[i]);
        sample.hit = hits[i];
        const double t = static_cast<double>(hits[i].t) + parts[i].first;
        sample.hit.t = static_cast<float>(t);
        sample.hit.hit = hits[i].hit && t <= parts[i].second;
        if (sample.hit.hit && attributes)
            blendAttributes(surface.surface(), hits[i].position, sample);
    });
}

} // namespace raycast
