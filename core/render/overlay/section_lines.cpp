#include "core/render/overlay/section_lines.h"

#include <QImage>
#include <QPainter>
#include <QPainterPath>

namespace render {

using base::Vec3d;

namespace {

/// Is the place in the picture: before the eye, kept by the other planes, and not hidden?
class Sight {
  public:
    Sight(const Camera& camera, std::size_t plane, const Image* depth)
        : m_camera(camera), m_plane(plane), m_depth(depth) {}

    bool sees(const Vec3d& p, double unit) const {
        for (std::size_t k = 0; k < m_camera.clips.all().size(); ++k)
            if (k != m_plane && m_camera.clips.all()[k].distance(p) < 0)
                return false;
        const Vec3d at = m_camera.project(p);
        if (!(at.z > 0))
            return false;
        const auto column = static_cast<int>(std::floor(at.x)), row = static_cast<int>(std::floor(at.y));
        if (!m_depth || column < 0 || row < 0 || column >= m_depth->width || row >= m_depth->height)
            return true;
        // The surface at the line itself stands as near; splats reach a little beyond the plane.
        const base::Rayd ray = m_camera.ray(at.x, at.y);
        const double depth = dot(p - ray.origin, ray.direction), slack = 0.2 * unit + 2 / m_camera.pixelsPerUnit(at.z);
        return depth <= nearest(column, row) + slack;
    }

  private:
    /// The farthest of a pixel and its neighbours: a cut edge is a pixel wide.
    double nearest(int column, int row) const {
        float out = 0;
        for (int y = std::max(0, row - 1); y <= std::min(m_depth->height - 1, row + 1); ++y)
            for (int x = std::max(0, column - 1); x <= std::min(m_depth->width - 1, column + 1); ++x)
                out = std::max(out,
                               m_depth->depth[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_depth->width) +
                                              static_cast<std::size_t>(x)]);
        return static_cast<double>(out);
    }

    const Camera& m_camera;
    std::size_t m_plane;
    const Image* m_depth;
};

void addCurve(QPainterPath& path, const surface::SectionCurve& curve, const Sight& sight, const Camera& camera) {
    bool drawing = false;
    const std::size_t count = curve.points.size() + (curve.closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
        const surface::SectionPoint& p = curve.points[i % curve.points.size()];
        if (!sight.sees(p.position, p.unit)) {
            drawing = false;
            continue;
        }
        const Vec3d at = camera.project(p.position);
        if (drawing)
            path.lineTo(at.x, at.y);
        else
            path.moveTo(at.x, at.y);
        drawing = true;
    }
}

} // namespace

void paintSections(QPainter& painter, const SectionCurves& curves, const Camera& camera, double widthPx,
                   const Image* depth) {
    QPainterPath path;
    for (std::size_t k = 0; k < curves.size(); ++k)
        for (const surface::SectionCurve& curve : curves[k])
            addCurve(path, curve, Sight(camera, k, depth), camera);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const auto pen = [&](QColor colour, double width) {
        return QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    painter.setPen(pen(QColor(20, 20, 24, 150), 2.2 * widthPx));
    painter.drawPath(path);
    painter.setPen(pen(QColor(255, 176, 64), widthPx));
    painter.drawPath(path);
    painter.restore();
}

void drawSections(const SectionCurves& curves, const Camera& camera, Image& image) {
    QImage view(reinterpret_cast<uchar*>(image.colour.data()), image.width, image.height,
                static_cast<qsizetype>(image.width) * 4, QImage::Format_RGBA8888);
    QPainter painter(&view);
    paintSections(painter, curves, camera, std::max(1.2, image.height / 500.0), &image);
}

} // namespace render
