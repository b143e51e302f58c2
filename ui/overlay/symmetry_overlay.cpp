#include "ui/overlay/symmetry_overlay.h"

#include "core/sculpt/mirror.h"

#include <array>
#include <QPainter>
#include <QPainterPath>

namespace ui {

using base::Vec3d;

/// By how much planes and axes reach beyond the model, as a part of its size.
constexpr double overhang = 0.06;

static QColor colourOf(int axis) {
    return axis == 0 ? QColor(235, 95, 85) : axis == 1 ? QColor(130, 205, 95) : QColor(95, 150, 245);
}

static bool seen(const render::Camera& camera, const Vec3d& p) {
    return camera.project(p).z > 0;
}
static QPointF pixelOf(const render::Camera& camera, const Vec3d& p) {
    const Vec3d at = camera.project(p);
    return {at.x, at.y};
}

/// A line in space, leaving out what is behind the eye.
static void addLine(QPainterPath& path, const render::Camera& camera, const Vec3d& a, const Vec3d& b) {
    constexpr int parts = 24;
    for (int k = 0; k < parts; ++k) {
        const Vec3d p = a + (b - a) * (double(k) / parts), q = a + (b - a) * (double(k + 1) / parts);
        if (!seen(camera, p) || !seen(camera, q))
            continue;
        path.moveTo(pixelOf(camera, p));
        path.lineTo(pixelOf(camera, q));
    }
}

static void stroke(QPainter& painter, const QPainterPath& path, QColor colour) {
    colour.setAlpha(120);
    painter.setPen(QPen(colour, 1.2));
    painter.drawPath(path);
}

/// The rectangle that the plane cuts out of the model's box, a little larger.
static void paintPlane(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera, int axis) {
    const auto n = static_cast<std::size_t>(axis), a = (n + 1) % 3, b = (n + 2) % 3;
    const Vec3d low = base::cast<double>(overlay.bounds.lo), high = base::cast<double>(overlay.bounds.hi);
    const double more = overhang * static_cast<double>(overlay.bounds.diagonal());
    std::array<Vec3d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
        corners[k][n] = -overlay.origin[n];
        corners[k][a] = k == 0 || k == 3 ? low[a] - more : high[a] + more;
        corners[k][b] = k < 2 ? low[b] - more : high[b] + more;
    }
    QPainterPath frame;
    QPolygonF area;
    bool whole = true;
    for (std::size_t k = 0; k < 4; ++k) {
        addLine(frame, camera, corners[k], corners[(k + 1) % 4]);
        whole = whole && seen(camera, corners[k]);
        area << pixelOf(camera, corners[k]);
    }
    QColor veil = colourOf(axis);
    veil.setAlpha(14);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    if (whole)
        painter.drawPolygon(area);
    painter.setBrush(Qt::NoBrush);
    stroke(painter, frame, colourOf(axis));
}

static void paintAxis(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera) {
    const auto n = static_cast<std::size_t>(overlay.symmetry.axis);
    const double more = 2 * overhang * static_cast<double>(overlay.bounds.diagonal());
    Vec3d from = -overlay.origin, to = from;
    from[n] = static_cast<double>(overlay.bounds.lo[n]) - more;
    to[n] = static_cast<double>(overlay.bounds.hi[n]) + more;
    QPainterPath line;
    addLine(line, camera, from, to);
    stroke(painter, line, colourOf(static_cast<int>(overlay.symmetry.axis)));
}

/// Where the brush's images touch, about: exact on a symmetric model.
static void paintImages(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera) {
    const auto images = sculpt::mirrors(overlay.symmetry, overlay.origin);
    for (std::size_t i = 1; i < images.size(); ++i) {
        const Vec3d at = base::cast<double>(images[i].position(base::cast<float>(overlay.contact->position)));
        if (!seen(camera, at))
            continue;
        painter.setPen(QPen(QColor(0, 0, 0, 110), 1.5));
        painter.setBrush(QColor(255, 205, 130));
        painter.drawEllipse(pixelOf(camera, at), 3, 3);
    }
}

void paint(QPainter& painter, const SymmetryOverlay& overlay, const render::Camera& camera) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool planes[] = {overlay.symmetry.planes.x, overlay.symmetry.planes.y, overlay.symmetry.planes.z};
    for (int axis = 0; axis < 3; ++axis)
        if (planes[axis])
            paintPlane(painter, overlay, camera, axis);
    if (overlay.symmetry.copies > 1)
        paintAxis(painter, overlay, camera);
    if (overlay.contact)
        paintImages(painter, overlay, camera);
    painter.restore();
}

/// A cross in a circle, as on a target.
void paintSource(QPainter& painter, const Vec3d& source, const render::Camera& camera) {
    if (!seen(camera, source))
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const QPointF at = pixelOf(camera, source);
    QPainterPath path;
    path.addEllipse(at, 8, 8);
    for (const QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        path.moveTo(at + way * 4);
        path.lineTo(at + way * 12);
    }
    strokeOnDark(painter, path, QColor(120, 220, 200), 1.5);
    painter.restore();
}

} // namespace ui
