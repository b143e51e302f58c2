// Scenes whose light can be worked out.
#pragma once

#include "core/raycast/illuminate.h"
#include "surface/shapes.h"

namespace scenes {

using base::Vec3d;
using base::Vec3f;
using raycast::LightPoint;
using raycast::LightScene;

inline raycast::Lighting lightingOf(raycast::Material material = raycast::Material::Matcap) {
    raycast::Lighting out;
    out.material = material;
    return out;
}

/// Looks along -z with y up, dark blue below light grey.
inline raycast::Viewer viewer() {
    raycast::Viewer out;
    out.top = {0.6f, 0.6f, 0.6f}, out.bottom = {0.1f, 0.15f, 0.3f};
    return out;
}

inline LightPoint pointAt(const Vec3d& x, const Vec3d& n, float unit) {
    LightPoint out;
    out.x = base::cast<float>(x), out.n = base::cast<float>(n), out.unit = unit;
    out.seen = raycast::Seen::Model;
    return out;
}

/// Places of the surface where rays meet it first.
inline std::vector<LightPoint> met(const LightScene& scene, std::span<const base::Rayd> rays) {
    std::vector<raycast::Sample> samples(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        samples[i].hit = intersect(scene.surface.surface(),
                                   {base::cast<float>(rays[i].origin), base::cast<float>(rays[i].direction)});
    std::vector<LightPoint> out(rays.size());
    findLightPoints(scene, {samples, [&](std::size_t i) { return rays[i]; }}, 0, out);
    return out;
}

/// Light along rays by way of the scene's material.
inline std::vector<Vec3f> lightAlong(const LightScene& scene, std::span<const base::Rayd> rays) {
    std::vector<raycast::Sample> samples(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
        samples[i].hit = intersect(scene.surface.surface(),
                                   {base::cast<float>(rays[i].origin), base::cast<float>(rays[i].direction)});
    std::vector<raycast::Lit> lit(rays.size());
    raycast::LightCounts counts;
    illuminate(scene, {samples, [&](std::size_t i) { return rays[i]; }}, lit, counts);
    std::vector<Vec3f> out;
    for (const raycast::Lit& l : lit)
        out.push_back(l.colour);
    return out;
}

inline float largest(const Vec3f& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

} // namespace scenes
