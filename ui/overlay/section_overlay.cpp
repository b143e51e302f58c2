#include "ui/overlay/section_overlay.h"

#include <QPainter>
#include <QPainterPath>

namespace ui {

static QPen penOf(surfel::Colour c, double width) {
    const QColor colour(int(c & 255u), int(c >> 8 & 255u), int(c >> 16 & 255u), int(c >> 24));
    return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

void paintSections(QPainter& painter, const render::LineRuns& lines, double widthPx) {
    QPainterPath path;
    for (const std::vector<render::ImagePoint>& run : lines) {
        path.moveTo(double(run.front().x), double(run.front().y));
        for (std::size_t i = 1; i < run.size(); ++i)
            path.lineTo(double(run[i].x), double(run[i].y));
    }
    const render::SectionPen pen;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(penOf(pen.shade, pen.shadeWidth * widthPx));
    painter.drawPath(path);
    painter.setPen(penOf(pen.line, widthPx));
    painter.drawPath(path);
    painter.restore();
}

} // namespace ui
