#include "core/sculpt/seam_snap.h"

#include "core/base/segment.h"
#include "core/cells/seam_lines.h"
#include "core/sculpt/contact.h"
#include "core/surface/projection/project.h"

namespace sculpt {

using base::Vec3d, base::Vec3f;

SeamSnap::SeamSnap(const surface::Surface& surface, float reach) : m_surface(surface), m_reach(reach) {
    for (const cells::SeamLine& line : cells::seamLines(surface)) {
        for (std::size_t i = 1; i < line.points.size(); ++i)
            m_segments.push_back({line.points[i - 1].position, line.points[i].position});
        if (!line.closed) {
            m_corners.push_back(line.points.front().position);
            m_corners.push_back(line.points.back().position);
        }
    }
}

base::Rayf SeamSnap::snapped(const base::Rayf& ray) const {
    const auto touched = contact(m_surface, ray);
    if (!touched)
        return ray;
    const Vec3d x = base::cast<double>(touched->position);
    const auto reach = static_cast<double>(m_reach);
    Vec3d best = x;
    double nearest = 0.5 * reach;
    for (const Vec3d& corner : m_corners)
        if (const double d = base::distance(corner, x); d < nearest) {
            nearest = d;
            best = corner;
        }
    if (best == x) {
        nearest = reach;
        for (const Segment& s : m_segments) {
            const Vec3d on = nearestOnSegment(s.from, s.to, x);
            if (const double far = base::distance(on, x); far < nearest) {
                nearest = far;
                best = on;
            }
        }
    }
    if (best == x)
        return ray;
    // Brushes meet the smooth surface of the same surfels, which is a little inside of the edge.
    if (const auto foot = surface::project(m_surface, base::cast<float>(best)); foot.ok())
        best = base::cast<double>(foot.foot);
    return {ray.origin + base::cast<float>(best - x), ray.direction};
}

} // namespace sculpt
