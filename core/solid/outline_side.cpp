#include "core/solid/outline_side.h"

#include "core/base/segment.h"

namespace solid {

using base::Point2;
using base::Vec3d;

Point2 PictureFrame::seen(const Vec3d& x) const {
    const double unit = scale(depth(x));
    return {dot(x - eye, right) / unit, dot(x - eye, upright) / unit};
}

OutlineSide::OutlineSide(const PictureFrame& frame, std::vector<Point2> corners)
    : m_frame(frame), m_corners(std::move(corners)), m_outline(m_corners), m_walls(wallsOf()), m_runs(runsOf()) {}

std::vector<OutlineSide::Wall> OutlineSide::wallsOf() const {
    std::vector<Wall> out;
    const auto end = [&](const Point2& p) {
        return m_frame.parallel ? m_frame.place(p, 0) - m_frame.eye : normalized(m_frame.place(p, 1) - m_frame.eye);
    };
    for (std::size_t k = 0; k < m_corners.size(); ++k) {
        const Vec3d from = end(m_corners[k]), to = end(m_corners[(k + 1) % m_corners.size()]);
        out.push_back({from, to, normalized(cross(from, to), {})});
    }
    return out;
}

/// About straight pieces of the picture, or arcs of directions: these leave their chords a little.
SegmentRuns OutlineSide::runsOf() const {
    std::vector<base::Box3d> boxes;
    for (const Wall& wall : m_walls) {
        base::Box3d box;
        box.extend(wall.from), box.extend(wall.to);
        const double cosine = dot(wall.from, wall.to);
        boxes.push_back(m_frame.parallel ? box : box.inflated(1 - std::sqrt(std::max(0.0, 0.5 + 0.5 * cosine))));
    }
    return SegmentRuns(boxes);
}

bool OutlineSide::holds(const Vec3d& x) const {
    return (m_frame.parallel || m_frame.depth(x) > 0) && m_outline.holds(m_frame.seen(x));
}

/// The nearest place of a strip, or of a sector.
Vec3d OutlineSide::onWall(const Wall& wall, const Vec3d& x) const {
    if (m_frame.parallel) {
        const Vec3d along = m_frame.forward * dot(x, m_frame.forward);
        return nearestOnSegment(wall.from, wall.to, x - along) + along;
    }
    if (lengthSq(wall.normal) > 0) {
        const Vec3d foot = x - wall.normal * dot(x, wall.normal);
        if (dot(cross(wall.from, foot), wall.normal) >= 0 && dot(cross(foot, wall.to), wall.normal) >= 0)
            return foot;
    }
    const Vec3d onFirst = wall.from * std::max(dot(x, wall.from), 0.0),
                onLast = wall.to * std::max(dot(x, wall.to), 0.0);
    return distanceSq(x, onFirst) <= distanceSq(x, onLast) ? onFirst : onLast;
}

/// In the plane of a picture with parallel rays, else among directions: the nearest sector is that of the least angle.
/// Of those at right angles and more each is as near as the eye.
std::size_t OutlineSide::nearestWall(const Vec3d& fromEye) const {
    if (m_frame.parallel) {
        const Vec3d x = fromEye - m_frame.forward * dot(fromEye, m_frame.forward);
        return m_runs.nearest(x, [&](std::size_t k) { return distanceSq(onWall(m_walls[k], x), x); });
    }
    const Vec3d x = normalized(fromEye, m_frame.forward);
    return m_runs.nearest(
        x, [&](std::size_t k) { return distanceSq(normalized(onWall(m_walls[k], x), m_walls[k].from), x); });
}

SideFoot OutlineSide::foot(const Vec3d& x) const {
    const Vec3d fromEye = x - m_frame.eye;
    const Wall& wall = m_walls[nearestWall(fromEye)];
    const Vec3d onIt = onWall(wall, fromEye), apart = fromEye - onIt;
    SideFoot out;
    out.foot = m_frame.eye + onIt;
    out.height = holds(x) ? -length(apart) : length(apart);
    // on the wall its own normal, whose direction the outline's tells beside it
    if (lengthSq(apart) > 1e-24 * lengthSq(onIt)) {
        out.gradient = apart / out.height;
    } else {
        const Vec3d normal =
            normalized(cross(wall.to - wall.from, m_frame.parallel ? m_frame.forward : onIt), m_frame.right);
        const bool ahead = holds(out.foot + normal * (1e-9 * length(onIt)));
        out.gradient = ahead ? -normal : normal;
    }
    out.ok = true;
    return out;
}

SideValue OutlineSide::at(const Vec3d& x) const {
    const SideFoot found = foot(x);
    return {found.height, found.gradient, true};
}

bool OutlineSide::meets(const base::Box3d& box) const {
    return std::abs(at(box.centre()).value) <= 0.5 * box.diagonal() * (1 + 1e-9);
}

} // namespace solid
