// The tool that a hand feels with: its ball on the surface, where the hand has it, and the force as an arrow.
#pragma once

#include "core/render/camera.h"

class QPainter;

namespace ui {

struct TouchLook {
    bool shown = false, contact = false, works = false;
    base::Vec3d tool, proxy; ///< centres: the hand's, and the one that stays outside
    double radius = 0;       ///< of the ball, in model units
    base::Vec3d force;       ///< newtons, in the model's directions
};

/// In device pixels of the camera's image, `pixelRatio` of them to a unit.
void paint(QPainter& painter, const TouchLook& look, const render::Camera& camera, double pixelRatio);

} // namespace ui
