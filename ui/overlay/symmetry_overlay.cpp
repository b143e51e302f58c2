#include "ui/overlay/symmetry_overlay.h"

#include "core/sculpt/mirror.h"

#include <QPainter>
#include <QPainterPath>

namespace ui {

using base::Vec3d;

/// By how much an axis reaches beyond the model, as a part of its size.
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

/// The curve where a plane meets the surface: clear where it faces the eye, faint behind the model. Runs of one kind,
/// since a curve changes sides.
static void paintCurves(QPainter& painter, const std::vector<surface::SectionCurve>& curves,
                        const render::Camera& camera, int axis, double widthPx) {
    QPainterPath near, far;
    for (const surface::SectionCurve& curve : curves) {
        const std::size_t n = curve.points.size(), ends = curve.closed ? n : n - std::min<std::size_t>(n, 1);
        for (std::size_t k = 0; k < ends; ++k) {
            const surface::SectionPoint &p = curve.points[k], &q = curve.points[(k + 1) % n];
            if (!seen(camera, p.position) || !seen(camera, q.position) || !camera.clips.keeps(p.position))
                continue;
            const Vec3d towards = camera.parallel() ? -camera.forward() : camera.eye - p.position;
            QPainterPath& path = dot(p.normal, towards) > 0 ? near : far;
            const QPointF from = pixelOf(camera, p.position);
            if (path.currentPosition() != from || path.elementCount() == 0)
                path.moveTo(from);
            path.lineTo(pixelOf(camera, q.position));
        }
    }
    QColor colour = colourOf(axis);
    colour.setAlpha(45);
    painter.setPen(QPen(colour, 0.7 * widthPx));
    painter.drawPath(far);
    colour.setAlpha(235);
    strokeOnDark(painter, near, colour, widthPx);
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
    painter.setBrush(Qt::NoBrush);
    for (int axis = 0; axis < 3; ++axis)
        if (planes[axis] && overlay.curves)
            paintCurves(painter, (*overlay.curves)[static_cast<std::size_t>(axis)], camera, axis, overlay.widthPx);
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
