#include "ui/overlay/brush_cursor.h"

#include <numbers>
#include <QPainter>
#include <QPainterPath>

namespace ui {

using base::Vec3d;

static QPointF pixelOf(const render::Camera& camera, const Vec3d& p) {
    const Vec3d at = camera.project(p);
    return {at.x, at.y};
}

/// The circle's points before the eye; those behind it are left out.
static QPolygonF tiltedCircle(const BrushCursor& cursor, const render::Camera& camera, double radius) {
    constexpr int corners = 72;
    const Vec3d u = base::perpendicular(cursor.contact->normal), v = base::cross(cursor.contact->normal, u);
    QPolygonF out;
    for (int k = 0; k <= corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners;
        const Vec3d p = cursor.contact->position + (u * std::cos(angle) + v * std::sin(angle)) * radius;
        if (camera.project(p).z > 0)
            out << pixelOf(camera, p);
    }
    return out;
}

void strokeOnDark(QPainter& painter, const QPainterPath& path, const QColor& colour, double width) {
    painter.setPen(QPen(QColor(0, 0, 0, 110), width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

void paint(QPainter& painter, const BrushCursor& cursor, const render::Camera& camera) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const QColor colour = cursor.inverted ? QColor(120, 190, 255) : QColor(255, 205, 130);
    QPainterPath path;
    QColor filling = colour;
    filling.setAlpha(90);
    if (cursor.contact) {
        if (cursor.strength) {
            QPainterPath inner;
            inner.addPolygon(tiltedCircle(cursor, camera, *cursor.strength * cursor.radius));
            painter.fillPath(inner, filling);
        }
        path.addPolygon(tiltedCircle(cursor, camera, cursor.radius));
        strokeOnDark(painter, path, colour, 1.6);
        const Vec3d tip = cursor.contact->position + cursor.contact->normal * (0.4 * cursor.radius);
        QPainterPath stick(pixelOf(camera, cursor.contact->position));
        if (camera.project(tip).z > 0)
            stick.lineTo(pixelOf(camera, tip));
        strokeOnDark(painter, stick, colour, 1.6);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(pixelOf(camera, cursor.contact->position), 2.5, 2.5);
    } else if (cursor.radiusPx > 0) {
        if (cursor.strength) {
            QPainterPath inner;
            inner.addEllipse(cursor.pointer, *cursor.strength * cursor.radiusPx, *cursor.strength * cursor.radiusPx);
            painter.fillPath(inner, filling);
        }
        painter.setPen(QPen(QColor(255, 255, 255, 70), 1.2, Qt::DashLine));
        painter.drawEllipse(cursor.pointer, cursor.radiusPx, cursor.radiusPx);
    }
    if (!cursor.label.isEmpty()) {
        QPainterPath text;
        text.addText(cursor.pointer + QPointF(16, -12), painter.font(), cursor.label);
        strokeOnDark(painter, text, QColor(0, 0, 0, 150), 1);
        painter.fillPath(text, Qt::white);
    }
    painter.restore();
}

} // namespace ui
