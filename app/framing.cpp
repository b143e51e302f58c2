#include "app/framing.h"

#include "core/render/close_up.h"
#include "core/render/framed_box.h"
#include "core/render/splats/splat_kernels.h"

#include <algorithm>
#include <cmath>

namespace app {

using base::Vec3d;

/// Part of the half image that points reach, with the discs that are drawn about them.
constexpr double filled = 0.9;
/// A disc counts as no larger than this part of the model's diagonal: what stands alone has a wide support.
constexpr float widestDisc = 0.02f;

/// What is framed, surfel by surfel, with the radius of its disc: a walk for close_up.h.
static auto shownOf(const tree::SurfelTree& model) {
    return [&model](const auto& fn) {
        const base::Box3f shown = render::framedBox(model);
        const float widest = widestDisc * shown.diagonal();
        model.forEachBlock([&](std::uint32_t, const surfel::SurfelBlock& block) {
            for (int slot = 0; slot < block.size(); ++slot)
                if (shown.contains(block.position(slot)))
                    fn(base::cast<double>(block.position(slot)),
                       static_cast<double>(std::min(widest, render::splatRadiusOfSupport * block.support(slot))));
        });
    };
}

/// The middle of the extents in the middle of the image, and all of the model before the eye.
static render::Camera middled(const render::Camera& camera, const tree::SurfelTree& model,
                              const render::framing::Extents& extents) {
    render::Camera out = camera;
    const Vec3d aside = extents.aside(camera);
    out.target += aside;
    out.eye += aside;
    return out.before(model.bounds());
}

/// With parallel rays, depth does not matter: the middle of the extents, and the height that holds them.
static render::Camera closeUpParallel(const render::Camera& camera, const tree::SurfelTree& model) {
    const render::framing::Extents extents(camera, shownOf(model));
    render::Camera out = camera;
    const double height = extents.height(camera, filled);
    if (height > 0) // else one point: any height shows it
        out.orthoHeight = height;
    return middled(out, model, extents);
}

render::Camera centred(const render::Camera& camera, const tree::SurfelTree& model) {
    return model.empty() ? camera : middled(camera, model, {camera, shownOf(model)});
}

/// Rodrigues' formula.
static Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

render::Camera turnedAbout(const render::Camera& camera, const Vec3d& axis, double angleRad) {
    render::Camera out = camera;
    out.eye = camera.target + turned(camera.eye - camera.target, axis, angleRad);
    out.up = turned(camera.up, axis, angleRad);
    return out;
}

render::Camera closeUp(const render::Camera& camera, const tree::SurfelTree& model) {
    if (model.empty())
        return camera;
    if (camera.parallel())
        return closeUpParallel(camera, model);
    const base::Box3f shown = render::framedBox(model);
    const Vec3d centre = base::cast<double>(shown.centre());
    if (shown.diagonal() > 0)
        return render::closeUpOf(camera, shownOf(model), centre, filled);
    render::Camera out = camera; // one point: any distance shows it
    out.target = centre;
    out.eye = centre + (camera.eye - camera.target);
    return out;
}

} // namespace app
