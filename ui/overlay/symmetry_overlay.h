// What symmetry does, faintly over the picture: mirror planes as frames around the model, the axis of radial symmetry,
// and a dot wherever else the brush works. Also the place that a tool copies from.
#pragma once

#include "core/sculpt/stroke_settings.h"
#include "ui/overlay/brush_cursor.h"

namespace ui {

struct SymmetryOverlay {
    sculpt::Symmetry symmetry;
    base::Vec3d origin;                  ///< of the model: what symmetry mirrors at is the file's zero
    base::Box3f bounds;                  ///< of the model, stored coordinates, not empty
    std::optional<BrushContact> contact; ///< of the brush itself
};

/// Both paint in device pixels of `camera`'s image.
void paint(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera);
void paintSource(QPainter& painter, const base::Vec3d& place, const render::Camera& camera);

} // namespace ui
