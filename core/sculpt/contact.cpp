#include "core/sculpt/contact.h"

#include "core/base/parallel.h"
#include "core/surface/rays/intersect.h"

#include <cmath>

namespace sculpt {

/// Cosine to the ray below which it is not for the ray to say which side it meets: within 6 degrees.
constexpr float grazing = 0.1f;

/// At an outline the place where a ray comes in and where it goes out are one, and which of them is found is a matter
/// of rounding; turned against the ray the normal of the latter would point inside.
static base::Vec3f outwards(const surface::Surface& surface, const base::Rayf& ray, const surface::RayHit<float>& hit) {
    if (!surface.tree().layout()->oriented || std::abs(dot(hit.normal, normalized(ray.direction))) > grazing)
        return hit.normal;
    const surface::Evaluationf at = surface.evaluate(hit.position, surface::Need::Gradient);
    return dot(at.gradient, hit.normal) < 0 ? -hit.normal : hit.normal;
}

std::optional<Contact> contact(const surface::Surface& surface, const base::Rayf& ray) {
    const surface::RayHit<float> hit = surface::intersect(surface, ray);
    if (!hit.hit || !isFinite(hit.position) || !isFinite(hit.normal))
        return {};
    return Contact{hit.position, outwards(surface, ray, hit), hit.t};
}

namespace {

/// Sums in double over one block; added up in tree order, so that threads do not show.
struct Sums {
    base::Vec3d position, normal;
    double count = 0;
};

Sums sumsOf(const surfel::SurfelBlock& block, bool oriented, const Contact& at, float radius) {
    Sums out;
    for (int slot = 0; slot < block.size(); ++slot) {
        const base::Vec3f p = block.position(slot);
        if (distanceSq(p, at.position) >= radius * radius)
            continue;
        base::Vec3f n = block.normal(slot);
        const float facing = dot(n, at.normal);
        if (facing <= 0 && oriented)
            continue;
        if (facing < 0)
            n = -n;
        out.position += base::cast<double>(p - at.position);
        out.normal += base::cast<double>(n);
        out.count += 1;
    }
    return out;
}

} // namespace

Area areaAround(const surface::Surface& surface, const Contact& at, float radius) {
    std::vector<const surfel::SurfelBlock*> blocks;
    surface.tree().forBlocksInBall(at.position, radius,
                                   [&](std::uint32_t, const surfel::SurfelBlock& b) { blocks.push_back(&b); });
    std::vector<Sums> parts(blocks.size());
    const bool oriented = surface.tree().layout()->oriented;
    base::parallelFor(blocks.size(), 16, [&](std::size_t i) { parts[i] = sumsOf(*blocks[i], oriented, at, radius); });
    Sums sum;
    for (const Sums& part : parts)
        sum.position += part.position, sum.normal += part.normal, sum.count += part.count;
    if (sum.count == 0 || length(sum.normal) < 0.1 * sum.count)
        return {at.position, at.normal};
    return {at.position + base::cast<float>(sum.position / sum.count), base::cast<float>(normalized(sum.normal))};
}

} // namespace sculpt
