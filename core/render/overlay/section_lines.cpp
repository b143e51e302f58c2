#include "core/render/overlay/section_lines.h"

namespace render {

using base::Vec3d;

namespace {

/// Is the place in the picture: before the eye, kept by the other planes, and not hidden?
class LineOfSight {
  public:
    static constexpr std::size_t noPlane = ~std::size_t(0);

    /// `plane`: whose section the curve is.
    LineOfSight(const Camera& camera, std::size_t plane, const Image* depth)
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

void addCurve(LineRuns& runs, const surface::SectionCurve& curve, const LineOfSight& sight, const Camera& camera) {
    bool drawing = false;
    const std::size_t count = curve.points.size() + (curve.closed ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) {
        const surface::SectionPoint& p = curve.points[i % curve.points.size()];
        const bool seen = sight.sees(p.position, p.unit);
        if (seen && !drawing)
            runs.emplace_back();
        if (seen) {
            const Vec3d at = camera.project(p.position);
            runs.back().push_back({static_cast<float>(at.x), static_cast<float>(at.y)});
        }
        drawing = seen;
    }
}

base::Vec3f opaque(surfel::Colour c) {
    return base::Vec3f{float(c & 255u), float(c >> 8 & 255u), float(c >> 16 & 255u)} * (1.0f / 255);
}

} // namespace

LineRuns sectionLines(const SectionCurves& curves, const Camera& camera, const Image* depth) {
    LineRuns out;
    for (std::size_t k = 0; k < curves.size(); ++k)
        for (const surface::SectionCurve& curve : curves[k])
            addCurve(out, curve, LineOfSight(camera, k, depth), camera);
    return out;
}

LineRuns curveLines(std::span<const surface::SectionCurve> curves, const Camera& camera, const Image* depth) {
    LineRuns out;
    for (const surface::SectionCurve& curve : curves)
        addCurve(out, curve, LineOfSight(camera, LineOfSight::noPlane, depth), camera);
    return out;
}

void drawSections(const LineRuns& lines, Image& image) {
    std::vector<PenLine> pieces;
    for (const std::vector<ImagePoint>& run : lines)
        for (std::size_t i = 1; i < run.size(); ++i)
            pieces.push_back({run[i - 1], run[i]});
    const SectionPen pen;
    const auto width = static_cast<float>(std::max(1.2, image.height / 500.0));
    const float wide = width * static_cast<float>(pen.shadeWidth);
    const base::Vec3f line = opaque(pen.line), shade = opaque(pen.shade);
    const float strength = static_cast<float>(pen.shade >> 24) / 255;
    const auto ink = [&](surfel::Colour under, float away) {
        return inked(inked(under, shade, strength * covered(wide, away)), line, covered(width, away));
    };
    draw(pieces, 0.5f * wide + 1, ink, image);
}

} // namespace render
