// The brush as it lies on the surface: a circle at the exact contact, tilted to the surface normal, with a stick along
// it. Where there is no contact, a faint circle follows the pointer.
#pragma once

#include "core/render/camera.h"

#include <optional>
#include <QPointF>
#include <QString>

class QColor;
class QPainter;
class QPainterPath;

namespace ui {

struct BrushContact {
    base::Vec3d position; ///< on the surface
    base::Vec3d normal;   ///< unit gradient, facing the viewer
};

struct BrushCursor {
    std::optional<BrushContact> contact;
    double radius = 0;     ///< model units, at the contact
    double radiusPx = 0;   ///< device pixels, where there is no contact
    QPointF pointer;       ///< device pixels
    bool inverted = false; ///< digs instead of builds: another colour
    /// 0 to 1, while it is changed: the part of the ring's radius that is filled.
    std::optional<double> strength;
    QString label; ///< beside the pointer, while something is changed by moving it; may be empty
};

/// Light on dark, so that it is seen on any clay: for whatever is painted over the model.
void strokeOnDark(QPainter& painter, const QPainterPath& path, const QColor& colour, double width);

/// Paints in device pixels of `camera`'s image.
void paint(QPainter& painter, const BrushCursor& cursor, const render::Camera& camera);

} // namespace ui
