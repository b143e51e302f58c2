#include "core/solid/outline_side.h"

#include <algorithm>

namespace solid {

using base::Vec3d;

Vec3d PictureFrame::seen(const Vec3d& x) const {
    const Vec3d from = x - eye;
    const double depth = dot(from, forward), scale = parallel ? 1 : depth;
    return {dot(from, right) / scale, dot(from, upright) / scale, depth};
}

OutlineSide::OutlineSide(const PictureFrame& frame, std::vector<PicturePoint> corners)
    : m_frame(frame), m_corners(std::move(corners)) {}

bool OutlineSide::holds(const PicturePoint& p) const {
    bool in = false;
    for (std::size_t i = 0, before = m_corners.size() - 1; i < m_corners.size(); before = i++) {
        const auto &a = m_corners[before], &b = m_corners[i];
        if ((a[1] > p[1]) != (b[1] > p[1])) // half open, so that a corner counts once
            in ^= p[0] < a[0] + (p[1] - a[1]) * (b[0] - a[0]) / (b[1] - a[1]);
    }
    return in;
}

/// The nearest place of a wall: the strip, in perspective the sector, between the rays of two corners.
Vec3d OutlineSide::wallFoot(std::size_t wall, const Vec3d& x) const {
    const auto &a = m_corners[wall], &b = m_corners[(wall + 1) % m_corners.size()];
    const Vec3d &eye = m_frame.eye, from = m_frame.place(a[0], a[1], 0), to = m_frame.place(b[0], b[1], 0);
    if (m_frame.parallel) {
        const Vec3d edge = to - from;
        const double share = lengthSq(edge) > 0 ? std::clamp(dot(x - from, edge) / lengthSq(edge), 0.0, 1.0) : 0;
        return from + edge * share + m_frame.forward * dot(x - from, m_frame.forward);
    }
    const Vec3d first = normalized(m_frame.place(a[0], a[1], 1) - eye),
                last = normalized(m_frame.place(b[0], b[1], 1) - eye);
    const Vec3d normal = cross(first, last);
    if (lengthSq(normal) > 0) {
        const Vec3d foot = x - normal * (dot(x - eye, normal) / lengthSq(normal));
        if (dot(cross(first, foot - eye), normal) >= 0 && dot(cross(foot - eye, last), normal) >= 0)
            return foot;
    }
    const Vec3d onFirst = eye + first * std::max(dot(x - eye, first), 0.0),
                onLast = eye + last * std::max(dot(x - eye, last), 0.0);
    return distanceSq(x, onFirst) <= distanceSq(x, onLast) ? onFirst : onLast;
}

SideFoot OutlineSide::foot(const Vec3d& x) const {
    SideFoot out;
    double least = std::numeric_limits<double>::infinity();
    std::size_t wall = 0;
    for (std::size_t k = 0; k < m_corners.size(); ++k)
        if (const Vec3d foot = wallFoot(k, x); distanceSq(foot, x) < least) {
            least = distanceSq(foot, x);
            out.foot = foot;
            wall = k;
        }
    const Vec3d seen = m_frame.seen(x);
    const bool inside = (m_frame.parallel || seen.z > 0) && holds({seen.x, seen.y});
    out.height = inside ? -std::sqrt(least) : std::sqrt(least);
    // on the wall its own normal, whose direction the outline's tells beside it
    const auto &a = m_corners[wall], &b = m_corners[(wall + 1) % m_corners.size()];
    const Vec3d apart = x - out.foot;
    Vec3d along = m_frame.forward, across = m_frame.right * (b[0] - a[0]) + m_frame.upright * (b[1] - a[1]);
    if (!m_frame.parallel)
        along = out.foot - m_frame.eye;
    const Vec3d normal = normalized(cross(across, along), m_frame.right);
    if (least > 1e-24 * lengthSq(out.foot - m_frame.eye)) {
        out.gradient = apart * (1 / out.height);
    } else {
        const Vec3d beside = m_frame.seen(out.foot + normal * (1e-9 * length(out.foot - m_frame.eye)));
        out.gradient = holds({beside.x, beside.y}) ? -normal : normal;
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
