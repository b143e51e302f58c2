// Measurements over the picture: what was measured along, its ends, and the number beside it. Nothing hides them.
#pragma once

#include "core/render/camera.h"

#include <QString>
#include <span>
#include <vector>

class QPainter;

namespace ui {

struct RulerMark {
    std::vector<base::Vec3d> line; ///< one place: a point
    QString text;
};

/// In device pixels of `camera`'s image. `picked`: places of a measurement that still wants some.
void paintRulers(QPainter& painter, std::span<const RulerMark> marks, std::span<const base::Vec3d> picked,
                 const render::Camera& camera, double pixelRatio);

} // namespace ui
