// Surfels that a command would take out, as red dots. Nothing hides them: what stands within the model is meant, too.
#pragma once

#include "core/render/camera.h"

#include <span>

class QPainter;

namespace ui {

/// In device pixels of `camera`'s image.
void paintGone(QPainter& painter, std::span<const base::Vec3d> places, const render::Camera& camera, double pixelRatio);

} // namespace ui
