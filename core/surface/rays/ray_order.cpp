#include "core/surface/rays/ray_order.h"

#include "core/base/parallel.h"
#include "core/tree/morton.h"

#include <algorithm>
#include <cmath>

namespace surface {

using base::Box3f;
using base::Vec3f;

constexpr std::size_t grain = 4096;
constexpr std::size_t together = 32; ///< rays that share what they read (intersect.cpp)

/// Where the ray enters the box, or the place in the box that it comes about nearest to.
static Vec3f entry(const base::Rayf& ray, const Box3f& box) {
    const auto [enter, leave] = base::clip(ray, box);
    const float t = enter <= leave ? enter : std::max(0.0f, dot(box.centre() - ray.origin, ray.direction));
    const Vec3f p = ray.at(t);
    Vec3f out;
    for (std::size_t k = 0; k < 3; ++k) // nothing that is no number
        out[k] = p[k] > box.lo[k] ? std::min(p[k], box.hi[k]) : box.lo[k];
    return out;
}

/// The mean of the unit directions is nearly one.
bool oneView(std::span<const base::Rayf> rays) {
    constexpr float least = 0.8f;
    constexpr std::size_t asked = 256;
    const std::size_t stride = rays.size() / std::min(asked, rays.size());
    Vec3f sum;
    float count = 0;
    for (std::size_t i = 0; i < rays.size(); i += stride, ++count)
        sum += base::normalized(rays[i].direction);
    return length(sum) >= least * count;
}

/// Do the runs of rays that share what they read reach further than a tile of them would?
static bool scattered(std::span<const Vec3f> places, const Box3f& all) {
    constexpr float further = 1.6f;
    constexpr std::size_t asked = 64;
    const std::size_t runs = places.size() / together, stride = std::max<std::size_t>(1, runs / asked);
    float sum = 0, count = 0;
    for (std::size_t run = 0; run < runs; run += stride, ++count) {
        Box3f box;
        for (const Vec3f& place : places.subspan(run * together, together))
            box.extend(place);
        sum += box.diagonal();
    }
    const float tile = all.diagonal() * std::sqrt(static_cast<float>(together) / static_cast<float>(places.size()));
    return sum > further * tile * count;
}

std::vector<std::uint32_t> viewOrder(std::span<const base::Rayf> rays, const Box3f& bounds) {
    if (rays.size() < 4 * together || bounds.empty() || !oneView(rays))
        return {};
    std::vector<Vec3f> places(rays.size());
    base::parallelFor(rays.size(), grain, [&](std::size_t i) { places[i] = entry(rays[i], bounds); });
    Box3f all;
    for (const Vec3f& place : places)
        all.extend(place);
    if (!scattered(places, all))
        return {};
    return tree::sortedIndices(places, all);
}

} // namespace surface
