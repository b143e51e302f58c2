#include "core/process/measuring/thickness.h"

#include "core/base/error.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <cmath>

namespace process {

using base::Vec3d, base::Vec3f;
using surface::Surface;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Of h: how far inside of the surface a ray begins, so that it does not meet where it comes from.
constexpr double within = 1e-3;

static void requireSides(const Surface& surface) {
    if (!surface.tree().layout()->normals || !surface.tree().layout()->oriented)
        throw base::Error("the surface has no inside: its normals have no sides", {}, "orient them first");
}

/// Met from within?
template <class T>
static bool leads(const surface::RayHit<T>& hit, const base::Vec3<T>& direction) {
    return hit.hit && dot(hit.outward, direction) > 0;
}

static ThicknessFigures figuresOf(const std::vector<double>& values) {
    ThicknessFigures out;
    std::vector<double> sorted;
    for (const double v : values)
        if (!std::isnan(v))
            sorted.push_back(v);
    out.count = sorted.size(), out.none = values.size() - sorted.size();
    if (sorted.empty())
        return out;
    double sum = 0;
    for (const double v : sorted)
        sum += v;
    std::sort(sorted.begin(), sorted.end());
    out.mean = sum / static_cast<double>(sorted.size());
    out.min = sorted.front(), out.max = sorted.back();
    out.p1 = sorted[sorted.size() / 100], out.median = sorted[sorted.size() / 2];
    return out;
}

Thicknesses thicknessesOf(const Surface& surface, const base::Progress& progress) {
    constexpr std::size_t slab = 8192;
    requireSides(surface);
    const surfel::SurfelList points = surface.tree().surfels();
    Thicknesses out;
    out.at.assign(points.size(), nothing);
    for (std::size_t first = 0; first < points.size(); first += slab) {
        progress.step(static_cast<double>(first) / static_cast<double>(points.size()), "Measuring thickness");
        const std::size_t count = std::min(slab, points.size() - first);
        std::vector<Vec3f> x(count);
        for (std::size_t i = 0; i < count; ++i)
            x[i] = points.items[first + i].position;
        std::vector<surface::Projection<float>> feet(count);
        surface::ProjectOptions how;
        how.checkBoundary = false;
        surface::project(surface, x, how, feet);
        std::vector<std::size_t> from;
        std::vector<base::Rayf> rays;
        std::vector<float> begun;
        for (std::size_t i = 0; i < count; ++i) {
            if (!feet[i].ok() || !(length(feet[i].at.gradient) > 0.05f))
                continue;
            const Vec3f inwards = -base::normalized(feet[i].at.gradient, points.items[first + i].normal);
            begun.push_back(static_cast<float>(within) * feet[i].at.unit);
            rays.push_back({feet[i].foot + inwards * begun.back(), inwards});
            from.push_back(first + i);
        }
        std::vector<surface::RayHit<float>> hits(rays.size());
        surface::intersect(surface, rays, {}, hits);
        for (std::size_t k = 0; k < rays.size(); ++k)
            if (leads(hits[k], rays[k].direction))
                out.at[from[k]] = static_cast<double>(begun[k]) + static_cast<double>(hits[k].t);
    }
    out.figures = figuresOf(out.at);
    return out;
}

ThicknessAt thicknessAt(const Surface& surface, const Vec3d& x) {
    requireSides(surface);
    ThicknessAt out{footOf(surface, x), {nothing, nothing, nothing}, nothing, nothing};
    const double begun = within * out.foot.unit;
    const base::Rayd ray{out.foot.position - out.foot.normal * begun, -out.foot.normal};
    const surface::RayHit<double> hit = surface::intersectReference(surface, ray);
    if (!leads(hit, ray.direction))
        return out;
    out.opposite = hit.position;
    out.thickness = begun + hit.t;
    out.leanRad = std::acos(std::clamp(dot(hit.outward, ray.direction), -1.0, 1.0));
    return out;
}

} // namespace process
