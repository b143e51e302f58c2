#include "core/raycast/light_points.h"

#include "core/base/parallel.h"
#include "core/cells/cell_value.h"

namespace raycast {

using base::Vec3d;
using base::Vec3f;

LightScene::LightScene(const cells::AnySurface& surface_, const Lighting& lighting_, const Viewer& viewer,
                       std::span<const base::Plane> clips_)
    : surface(surface_), lighting(lighting_), environment(lighting_, viewer), clips(clips_) {
    const base::Box3f box = surface.tree().bounds();
    const surfel::AttributeLayout& layout = *surface.tree().layout();
    oriented = layout.normals && layout.oriented;
    size = box.diagonal() > 0 ? box.diagonal() : 1;
    if (!lighting.ground || box.empty())
        return;
    std::size_t axis = 0;
    const Vec3f& up = environment.up();
    for (std::size_t k = 1; k < 3; ++k)
        axis = std::abs(up[k]) > std::abs(up[axis]) ? k : axis;
    const bool down = up[axis] < 0;
    Vec3d normal;
    normal[axis] = down ? -1 : 1;
    ground = base::Plane{normal, down ? -static_cast<double>(box.hi[axis]) : static_cast<double>(box.lo[axis])};
    middle = box.centre();
    middle[axis] = down ? box.hi[axis] : box.lo[axis];
}

/// The ground fades between these distances from the middle, in diagonals.
constexpr float groundFrom = 1.1f, groundTo = 2.6f;

static bool meetGround(const LightScene& scene, const base::Rayd& ray, LightPoint& out) {
    const double height = scene.ground->distance(ray.origin), fall = -dot(scene.ground->normal, ray.direction);
    if (!(height > 0 && fall > 0))
        return false;
    out.x = base::cast<float>(ray.at(height / fall));
    out.n = base::cast<float>(scene.ground->normal);
    const float away = base::distance(out.x, scene.middle) / scene.size;
    const float t = std::clamp((away - groundFrom) / (groundTo - groundFrom), 0.0f, 1.0f);
    out.fade = 1 - t * t * (3 - 2 * t);
    out.unit = 0.01f * scene.size;
    out.seen = out.fade > 0 ? Seen::Ground : Seen::Nothing;
    return out.fade > 0;
}

/// f with its gradient; of models with cells that of the local Boolean.
static surface::Evaluationf evaluationAt(const cells::AnySurface& surface, const Vec3f& x) {
    if (surface.cells()) {
        const cells::CellValue sharp =
            cells::evaluate(*surface.cells(), base::cast<double>(x), surface::Need::Gradient);
        if (sharp.mixed) {
            surface::Evaluationf out;
            out.status = sharp.at.status;
            out.value = static_cast<float>(sharp.at.value);
            out.gradient = base::cast<float>(sharp.at.gradient);
            out.unit = static_cast<float>(sharp.at.unit);
            return out;
        }
    }
    return surface.surface().evaluate(x);
}

/// Newton steps along the gradient: of a fifth of a spacing two of them leave far less than any epsilon.
static void settle(const cells::AnySurface& surface, LightPoint& point) {
    constexpr int steps = 2;
    constexpr float enough = 1e-4f, most = 0.5f;            // of h
    for (int k = 0; k < steps && !surface.complex(); ++k) { // whose rays are exact
        const surface::Evaluationf at = evaluationAt(surface, point.x);
        if (!at.ok() && at.status != surface::Status::BeyondBoundary)
            return;
        point.unit = at.unit;
        const float slopeSq = lengthSq(at.gradient);
        if (!(std::abs(at.value) > enough * at.unit) || !(slopeSq > 0.01f) || std::abs(at.value) > most * at.unit)
            return;
        point.x -= at.gradient * (at.value / slopeSq);
    }
}

void findLightPoints(const LightScene& scene, const SeenSamples& seen, std::size_t begin, std::span<LightPoint> out) {
    base::parallelFor(out.size(), 256, [&](std::size_t k) {
        const std::size_t i = begin + k;
        const surface::RayHit<float>& hit = seen.samples[i].hit;
        LightPoint& point = out[k];
        point = {};
        if (hit.hit) {
            point.x = hit.position, point.n = hit.normal, point.unit = hit.unit;
            point.seen = Seen::Model;
            point.back = scene.oriented && dot(hit.normal, hit.outward) < 0;
            settle(scene.surface, point);
        } else if (scene.ground) {
            meetGround(scene, seen.ray(i), point);
        }
    });
}

Vec3f secondaryOrigin(const LightPoint& point, const Vec3f& n) {
    constexpr float epsilon =
        2 * static_cast<float>(surface::secondaryEpsilon) * static_cast<float>(surface::spacingOfUnit);
    const float rounding = 4e-7f * length(point.x);
    return point.x + n * std::max(epsilon * point.unit, rounding);
}

} // namespace raycast
