#include "core/complexes/foot_on_cell.h"

#include <algorithm>
#include <utility>

namespace complexes {

using base::Vec3d;
using surface::Projector, surface::Status;

namespace {

/// The unit tangent of a curve at a place on it, pointing from there into the curve's inside: for its ends.
Vec3d inwards(const Complex& complex, std::uint32_t curve, const Vec3d& end) {
    const CellFrame frame = frameOf(complex, curve, end);
    if (!frame.ok())
        return {};
    return dot(frame.axis, frame.ownCentre - end) < 0 ? -frame.axis : frame.axis;
}

/// Past an end of a curve? REQUIRES: something is attached.
bool pastEnd(const Complex& complex, std::uint32_t curve, const Vec3d& x, const CellFrame& frame) {
    if (complex[curve].boundary.size() < 2) // closed, perhaps through one point
        return false;
    const Vec3d& end = frame.attached.front().foot; // the nearest one
    return dot(x - end, inwards(complex, curve, end)) < 0;
}

/// In the plane of a patch: across the tangent of a curve, towards the patch's own points.
Vec3d towardsInside(const CellFrame& frame, const Vec3d& tangent, const Vec3d& at) {
    const Vec3d m = cross(frame.axis, tangent);
    return dot(m, frame.ownCentre - at) < 0 ? -m : m;
}

/// At a corner of a patch: its two curves bound a sector. Below 180 degrees what is past one of them is outside, above
/// only what is past both.
bool pastCorner(const Complex& complex, std::uint32_t patch, const Vec3d& x, const Vec3d& corner,
                const CellFrame& frame) {
    const CellFrame here = frameOf(complex, patch, corner, frame.axis);
    const CellFrame& plane = here.ok() ? here : frame;
    std::vector<Vec3d> tangents, inside;
    for (const Attached& each : frame.attached) {
        if (base::distance(each.foot, corner) > 1e-6 * each.reach)
            continue;
        const Vec3d tangent = inwards(complex, each.cell, corner);
        if (tangent == Vec3d{})
            continue;
        tangents.push_back(tangent);
        inside.push_back(towardsInside(plane, tangent, corner));
    }
    if (tangents.empty())
        return false;
    if (tangents.size() == 1)
        return dot(x - corner, inside[0]) < 0;
    const bool first = dot(x - corner, inside[0]) < 0, second = dot(x - corner, inside[1]) < 0;
    const bool reflex = dot(tangents[1], inside[0]) < 0;
    return reflex ? first && second : first || second;
}

/// The iteration of one foot.
class Walk {
  public:
    Walk(const Complex& complex, std::uint32_t cell, const Vec3d& from, const FootOptions& options)
        : m_complex(complex), m_cell(cell), m_from(from), m_options(options) {}

    CellFoot run() {
        Vec3d x = start();
        CellFoot out;
        constexpr int most = 100;
        constexpr double settled = 1e-13, enough = 1e-9; // of h
        double moved = std::numeric_limits<double>::infinity();
        CellFrame frame;
        for (out.iterations = 0; out.iterations < most; ++out.iterations) {
            frame = frameOf(m_complex, m_cell, x, m_options.side);
            if (!frame.ok()) {
                out.status = frame.status;
                return m_options.anywhere && m_options.restricted ? nearestOnBoundary(m_from, out) : out;
            }
            if (frame.reached && m_options.restricted)
                return onBoundary(frame, out);
            const Vec3d next = step(x, frame);
            const double by = base::distance(next, x), before = std::exchange(moved, by);
            x = next;
            if (by < settled * frame.unit || (by < enough * frame.unit && by >= before))
                break;
        }
        out.status = moved < enough * frame.unit ? Status::Ok : Status::NotConverged;
        out.position = x;
        out.axis = frame.axis;
        out.on = m_cell;
        out.unit = frame.unit;
        if (out.ok() && m_options.restricted && isPast(m_complex, m_cell, x, frame))
            return onBoundary(frameOf(m_complex, m_cell, x, m_options.side), out);
        return out;
    }

  private:
    Vec3d start() const {
        const tree::SurfelTree& tree = m_complex[m_cell].own.tree();
        const CellFrame frame = m_options.anywhere ? frameOf(m_complex, m_cell, m_from) : CellFrame{};
        if (!m_options.anywhere || (frame.ok() && !frame.offCentre(m_from)))
            return m_from;
        std::vector<tree::Neighbour> near;
        if (!tree.empty())
            tree.nearest(base::cast<float>(m_from), 1, near);
        if (!near.empty())
            return base::cast<double>(near[0].block->position(near[0].slot));
        return nearestOnBoundary(m_from, {}).position;
    }

    /// Where the cell itself has nothing to say: of its boundary's points the one that is nearest.
    CellFoot nearestOnBoundary(const Vec3d& x, CellFoot out) const {
        FootOptions options;
        options.projector = Projector::Almost;
        options.anywhere = true;
        double nearest = std::numeric_limits<double>::infinity();
        for (const std::uint32_t b : m_complex[m_cell].boundary)
            if (const CellFoot foot = footOn(m_complex, b, x, options);
                foot.ok() && base::distance(foot.position, x) < nearest) {
                const Vec3d axis = out.axis;
                out = foot;
                out.axis = axis;
                nearest = base::distance(foot.position, x);
            }
        return out;
    }

    /// The boundary's own foot, exactly as the boundary itself gives it.
    CellFoot onBoundary(const CellFrame& frame, CellFoot out) const {
        if (frame.attached.empty())
            return nearestOnBoundary(out.position, out);
        const Attached& nearest = frame.attached.front();
        out.status = Status::Ok;
        out.axis = frame.ok() ? frame.axis : out.axis;
        out.unit = frame.unit;
        out.position = nearest.foot;
        out.on = nearest.cell;
        if (m_complex[nearest.cell].dimension == 1) {
            const CellFoot foot = footOn(m_complex, nearest.cell, nearest.foot, {});
            out.on = foot.ok() ? foot.on : nearest.cell;
            out.position = foot.ok() ? foot.position : nearest.foot;
        }
        return out;
    }

    Vec3d step(const Vec3d& x, const CellFrame& frame) {
        const int dimension = m_complex[m_cell].dimension;
        if (m_options.projector == Projector::Basic)
            return frame.foot(dimension, x);
        if (m_options.projector == Projector::Orthogonal && dimension == 2) {
            const Vec3d g = gradientOf(m_complex, m_cell, x, frame);
            if (const double squared = lengthSq(g); squared > 0.25)
                return limited(x, m_from - g * ((dot(frame.axis, x - frame.centre) + dot(g, m_from - x)) / squared),
                               frame);
        }
        return limited(x, frame.foot(dimension, m_from), frame);
    }

    /// Across the cell all the way. Along it by as much as the last step has shown to be right [Barzilai88]: seen from
    /// beyond the centre of a bend whole steps swing to and fro.
    Vec3d limited(const Vec3d& x, const Vec3d& next, const CellFrame& frame) {
        const Vec3d below = frame.foot(m_complex[m_cell].dimension, x), along = next - below;
        double part = 1;
        if (m_step != Vec3d{}) {
            const double change = dot(m_step, m_along - along);
            part = change > 0 ? std::clamp(lengthSq(m_step) / change, leastPart, 1.0) : 1.0;
        }
        m_along = along;
        const double by = part * length(along), most = 0.25 * frame.unit;
        m_step = along * (by <= most ? part : part * most / by);
        return below + m_step;
    }

    const Complex& m_complex;
    std::uint32_t m_cell;
    Vec3d m_from;
    FootOptions m_options;
    Vec3d m_along, m_step; ///< of the last step: all that it might have been along the cell, and what was taken
    static constexpr double leastPart = 1.0 / 1024;
};

} // namespace

/// Where the boundary's own points do not reach, and the cell's own all lie to one side: what it ends in.
static CellFrame withFarBoundary(const Complex& complex, std::uint32_t cell, const Vec3d& x, CellFrame frame) {
    constexpr double inside = 0.25, reach = 1.5; // of h
    if (base::distance(x, frame.ownCentre) < inside * frame.unit)
        return frame;
    FootOptions anywhere;
    anywhere.projector = Projector::Almost;
    anywhere.anywhere = true;
    for (const std::uint32_t b : complex[cell].boundary)
        if (const CellFoot foot = footOn(complex, b, x, anywhere); foot.ok()) {
            const double d = base::distance(x, foot.position);
            if (d < reach * frame.unit)
                frame.attached.push_back({b, foot.position, {}, d, reachOfUnit * foot.unit});
        }
    std::sort(frame.attached.begin(), frame.attached.end(),
              [](const Attached& a, const Attached& b) { return a.distance < b.distance; });
    return frame;
}

bool isPast(const Complex& complex, std::uint32_t cell, const Vec3d& x, const CellFrame& near) {
    if (near.reached)
        return false;
    const CellFrame frame = near.attached.empty() ? withFarBoundary(complex, cell, x, near) : near;
    if (frame.attached.empty())
        return false;
    if (complex[cell].dimension == 1)
        return pastEnd(complex, cell, x, frame);
    const Attached& nearest = frame.attached.front();
    for (const std::uint32_t end : complex[nearest.cell].boundary)
        if (base::distance(complex.place(end), nearest.foot) < 1e-6 * nearest.reach)
            return pastCorner(complex, cell, x, complex.place(end), frame);
    const CellFrame curve = frameOf(complex, nearest.cell, nearest.foot);
    if (!curve.ok())
        return false;
    return dot(x - nearest.foot, towardsInside(frame, curve.axis, nearest.foot)) < 0;
}

Vec3d gradientOf(const Complex& complex, std::uint32_t cell, const Vec3d& x, const CellFrame& frame) {
    const double step = 1e-5 * frame.unit;
    Vec3d out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec3d to;
        to[axis] = step;
        const CellFrame after = frameOf(complex, cell, x + to, frame.axis),
                        before = frameOf(complex, cell, x - to, frame.axis);
        if (!after.ok() || !before.ok())
            return {};
        out[axis] = (dot(after.axis, x + to - after.centre) - dot(before.axis, x - to - before.centre)) / (2 * step);
    }
    return out;
}

CellFoot footOn(const Complex& complex, std::uint32_t cell, const Vec3d& x, const FootOptions& options) {
    if (complex[cell].dimension == 0) {
        CellFoot out;
        out.status = Status::Ok;
        out.position = complex.place(cell);
        out.on = cell;
        out.unit = complex.reach(cell) / reachOfUnit;
        return out;
    }
    return Walk(complex, cell, x, options).run();
}

} // namespace complexes
