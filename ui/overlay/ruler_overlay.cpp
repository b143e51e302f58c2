#include "ui/overlay/ruler_overlay.h"

#include <cmath>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

namespace ui {

static const QColor bright(255, 214, 120), dark(12, 12, 14, 200);

/// The pixels of places in front of the eye.
static std::vector<QPointF> seen(std::span<const base::Vec3d> places, const render::Camera& camera) {
    std::vector<QPointF> out;
    for (const base::Vec3d& each : places)
        if (const base::Vec3d at = camera.project(each); at.z > 0)
            out.emplace_back(at.x, at.y);
    return out;
}

static void paintDots(QPainter& painter, std::span<const QPointF> at, double radius) {
    painter.setPen(QPen(dark, 0.6 * radius));
    painter.setBrush(bright);
    for (const QPointF& each : at)
        painter.drawEllipse(each, radius, radius);
    painter.setBrush(Qt::NoBrush);
}

static void paintLine(QPainter& painter, std::span<const QPointF> at, double width) {
    QPainterPath path(at.front());
    for (const QPointF& each : at.subspan(1))
        path.lineTo(each);
    painter.setPen(QPen(dark, 2.4 * width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(bright, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

/// Beside the middle of the line, on a plate.
static void paintText(QPainter& painter, const QPointF& at, const QString& text, double pixelRatio) {
    QFont font = painter.font();
    font.setPixelSize(qRound(13 * pixelRatio));
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    const double pad = 5 * pixelRatio;
    const QRectF plate(at.x() + 2 * pad, at.y() - metrics.height() - pad, metrics.horizontalAdvance(text) + 2 * pad,
                       metrics.height() + pad);
    painter.setPen(Qt::NoPen);
    painter.setBrush(dark);
    painter.drawRoundedRect(plate, pad, pad);
    painter.setPen(bright);
    painter.drawText(plate, Qt::AlignCenter, text);
}

void paintRulers(QPainter& painter, std::span<const RulerMark> marks, std::span<const base::Vec3d> picked,
                 const render::Camera& camera, double pixelRatio) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const RulerMark& mark : marks) {
        const std::vector<QPointF> at = seen(mark.line, camera);
        if (at.empty())
            continue;
        paintLine(painter, at, 1.5 * pixelRatio);
        const QPointF ends[] = {at.front(), at.back()};
        paintDots(painter, ends, 3.5 * pixelRatio);
        const QPointF middle = at.size() == 2 ? 0.5 * (at[0] + at[1]) : at[at.size() / 2];
        paintText(painter, middle, mark.text, pixelRatio);
    }
    paintDots(painter, seen(picked, camera), 3.5 * pixelRatio);
    painter.restore();
}

} // namespace ui
