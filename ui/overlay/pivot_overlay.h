// What the view turns about, as a small ring: bright while it turns.
#pragma once

#include "core/render/camera.h"

class QPainter;

namespace ui {

/// In device pixels of `camera`'s image.
void paintPivot(QPainter& painter, const base::Vec3d& place, const render::Camera& camera, bool turning);

} // namespace ui
