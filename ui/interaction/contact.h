// What lies under a pixel: the exact contact of its ray with the surface, as far as planes leave the surface shown.
// Free functions of their arguments, from any thread. Pixels are device pixels of the camera's image.
#pragma once

#include "core/surface/surface.h"
#include "ui/overlay/brush_cursor.h"

namespace ui {

std::optional<BrushContact> contactAt(const surface::Surface& surface, const render::Camera& camera,
                                      const QPointF& pixel);
/// The ray of a stroke's sample, beginning where no plane cuts it; nothing where planes leave nothing to be seen.
std::optional<base::Rayf> strokeRay(const surface::Surface& surface, const render::Camera& camera,
                                    const QPointF& pixel);

} // namespace ui
