#include "ui/overlay/gone_overlay.h"

#include <QPainter>
#include <vector>

namespace ui {

void paintGone(QPainter& painter, std::span<const base::Vec3d> places, const render::Camera& camera,
               double pixelRatio) {
    if (places.empty())
        return;
    std::vector<QPointF> at;
    at.reserve(places.size());
    for (const base::Vec3d& each : places)
        if (const base::Vec3d pixel = camera.project(each); pixel.z > 0)
            at.emplace_back(pixel.x, pixel.y);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false); // thousands of them
    painter.setPen(QPen(QColor(255, 70, 60), 3 * pixelRatio, Qt::SolidLine, Qt::SquareCap));
    painter.drawPoints(at.data(), static_cast<int>(at.size()));
    painter.restore();
}

} // namespace ui
