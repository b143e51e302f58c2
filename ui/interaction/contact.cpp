#include "ui/interaction/contact.h"

#include "core/surface/rays/intersect.h"

#include <cmath>

namespace ui {

/// The ray from where no plane cuts it.
static base::Rayf uncut(const base::Rayd& ray, const base::RayPart& part) {
    return {base::cast<float>(ray.at(part.first)), base::normalized(base::cast<float>(ray.direction))};
}

std::optional<BrushContact> contactAt(const surface::Surface& surface, const render::Camera& camera,
                                      const QPointF& pixel) {
    const base::Rayd ray = camera.ray(pixel.x(), pixel.y());
    const base::RayPart part = camera.uncut(ray);
    if (surface.tree().empty() || part.empty())
        return {};
    const surface::RayHit<float> hit = surface::intersect(surface, uncut(ray, part));
    if (!hit.hit || static_cast<double>(hit.t) + part.first > part.second)
        return {};
    return BrushContact{base::cast<double>(hit.position), base::cast<double>(hit.normal)};
}

std::optional<base::Rayf> strokeRay(const surface::Surface& surface, const render::Camera& camera,
                                    const QPointF& pixel) {
    const base::Rayd ray = camera.ray(pixel.x(), pixel.y());
    const base::RayPart part = camera.uncut(ray);
    if (part.empty() || (std::isfinite(part.second) && !contactAt(surface, camera, pixel)))
        return {};
    return uncut(ray, part);
}

} // namespace ui
