// What symmetry does: a line on the surface where a mirror plane meets it, the axis of radial symmetry, and a dot
// wherever else the brush works. Also the place that a tool copies from.
#pragma once

#include "core/sculpt/stroke/stroke_settings.h"
#include "core/surface/curves/section.h"
#include "ui/overlay/brush_cursor.h"

#include <array>

namespace ui {

/// Where the planes across x, y and z meet the surface.
using AxisCurves = std::array<std::vector<surface::SectionCurve>, 3>;

struct SymmetryOverlay {
    sculpt::Symmetry symmetry;
    base::Vec3d origin;                  ///< of the model: what symmetry mirrors at is the file's zero
    base::Box3f bounds;                  ///< of the model, stored coordinates, not empty
    std::optional<BrushContact> contact; ///< of the brush itself
    const AxisCurves* curves = nullptr;  ///< null: not traced
    double widthPx = 1.5;                ///< of a line, in device pixels
};

/// Both paint in device pixels of `camera`'s image.
void paint(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera);
void paintSource(QPainter& painter, const base::Vec3d& place, const render::Camera& camera);

} // namespace ui
