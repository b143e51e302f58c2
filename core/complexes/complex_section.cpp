#include "core/complexes/complex_section.h"

#include "core/base/cancel_scope.h"
#include "core/base/parallel.h"
#include "core/complexes/curve_trace.h"
#include "core/complexes/foot_on_cell.h"
#include "core/surface/curves/curve_tracing.h"
#include "core/surface/curves/traced_lines.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace complexes {

using base::Plane, base::Vec3d;
using surface::SectionCurve, surface::SectionPoint;

namespace {

constexpr double tolerance = 1e-11; ///< in units of h: of f
constexpr double leastSine = 1e-3;  ///< of the angle between plane and patch: below it they touch
constexpr double longestStep = 0.3; ///< in units of h
constexpr double onCurve = 0.02;    ///< in units of h: how far a point may be from the polyline of its curve
constexpr double besideCurve = 0.1; ///< in units of h: patches are looked for so far inside of their boundary
constexpr double joined = 0.01;     ///< in units of h: how far ends at one place are apart
constexpr double shortest = 1e-6;   ///< in units of h: less is a corner that the plane touches

using Piece = surface::TracedCurve<SectionPoint>;

/// The curve of one patch, for surface::traceCurve.
class PatchSection {
  public:
    using Point = SectionPoint;

    PatchSection(const Complex& complex, std::uint32_t patch, const Plane& plane)
        : m_complex(complex), m_patch(patch), m_plane(plane) {}

    const surface::Surface& surface() const { return m_complex[m_patch].own; }

    /// Along the plane and across the patch, by secants.
    std::optional<SectionPoint> find(const Vec3d& start, const surface::OrientationHint& hint = {}) const {
        constexpr int most = 30;
        const Vec3d side = base::cast<double>(hint.direction);
        const Vec3d from = start - m_plane.normal * m_plane.distance(start);
        CellFrame frame = frameOf(m_complex, m_patch, from, side);
        if (!frame.ok())
            return std::nullopt;
        const Vec3d across = frame.axis - m_plane.normal * dot(frame.axis, m_plane.normal);
        if (!(length(across) > leastSine))
            return std::nullopt;
        const Vec3d way = base::normalized(across);
        double t = 0, f = dot(frame.axis, from - frame.centre), slope = length(across);
        for (int k = 0; k < most; ++k) {
            if (std::abs(f) <= tolerance * frame.unit + rounding * length(from))
                return pointAt(from + way * t, frame);
            const double step = std::clamp(-f / slope, -longestStep * frame.unit, longestStep * frame.unit);
            const Vec3d x = from + way * (t + step);
            frame = frameOf(m_complex, m_patch, x, frame.axis);
            if (!frame.ok())
                return std::nullopt;
            const double now = dot(frame.axis, x - frame.centre);
            if (const double seen = (now - f) / step; std::abs(seen) > 0.1 * std::abs(slope))
                slope = seen;
            t += step;
            f = now;
        }
        return std::nullopt;
    }

    bool holds(const SectionPoint& p) const {
        const CellFrame frame = frameOf(m_complex, m_patch, p.position, p.normal);
        return frame.ok() && !frame.offCentre(p.position) && !isPast(m_complex, m_patch, p.position, frame);
    }

  private:
    static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon(); ///< of a coordinate

    std::optional<SectionPoint> pointAt(const Vec3d& x, const CellFrame& frame) const {
        const Vec3d gradient = gradientOf(m_complex, m_patch, x, frame);
        if (!(dot(gradient, frame.axis) >= surface::minSlope))
            return std::nullopt;
        const Vec3d normal = base::normalized(gradient);
        return SectionPoint{x, normal, base::normalized(cross(m_plane.normal, normal)), frame.unit};
    }

    const Complex& m_complex;
    std::uint32_t m_patch;
    const Plane& m_plane;
};

/// Where the plane may cut a patch: its own points near the plane, and beside where its boundary crosses.
std::vector<Vec3d> startsOf(const Complex& complex, std::uint32_t patch, const Plane& plane,
                            const std::vector<std::vector<Vec3d>>& crossings) {
    std::vector<Vec3d> out = surface::surfelsNear(complex[patch].own.tree(), plane);
    std::vector<Vec3d> ends;
    for (const std::uint32_t curve : complex[patch].boundary)
        ends.insert(ends.end(), crossings[curve].begin(), crossings[curve].end());
    for (const Vec3d& x : ends) {
        const CellFrame frame = frameOf(complex, patch, x);
        const Vec3d inwards = frame.ownCentre - x;
        const Vec3d inPlane = inwards - plane.normal * dot(inwards, plane.normal);
        out.push_back(x + base::normalized(inPlane) * (besideCurve * frame.unit));
        // in a corner it is the middle of both ends that lies within
        const Vec3d* nearest = nullptr;
        for (const Vec3d& y : ends)
            if (&y != &x && (!nearest || distanceSq(x, y) < distanceSq(x, *nearest)))
                nearest = &y;
        if (nearest)
            out.push_back((x + *nearest) / 2);
    }
    return out;
}

std::vector<Piece> piecesOf(const Complex& complex, std::uint32_t patch, const Plane& plane,
                            const std::vector<std::vector<Vec3d>>& crossings, const surface::TraceOptions& options) {
    const PatchSection section(complex, patch, plane);
    surface::TracedLines traced;
    std::vector<Piece> out;
    for (const Vec3d& start : startsOf(complex, patch, plane, crossings)) {
        base::CancelScope::check();
        const auto seed = section.find(start);
        if (!seed || base::distance(seed->position, start) > seed->unit || !section.holds(*seed) ||
            traced.lineAt(*seed, onCurve) >= 0)
            continue;
        Piece piece = surface::traceCurve(section, *seed, options);
        traced.add(piece.points, piece.closed, out.size());
        if (surface::arcLength(piece.points, piece.closed) > shortest * seed->unit)
            out.push_back(std::move(piece));
    }
    return out;
}

std::vector<Vec3d> crossingsOf(const Complex& complex, std::uint32_t curve, const Plane& plane) {
    const std::vector<Vec3d> places = trace(complex, curve).points;
    std::vector<Vec3d> out;
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double a = plane.distance(places[i - 1]), b = plane.distance(places[i]);
        if ((a > 0) != (b > 0))
            out.push_back(places[i - 1] + (places[i] - places[i - 1]) * (a / (a - b)));
    }
    return out;
}

void turn(std::vector<SectionPoint>& points) {
    std::reverse(points.begin(), points.end());
    for (SectionPoint& p : points)
        p.normal = -p.normal, p.along = -p.along;
}

/// Pieces whose ends are one place become one curve. A patch whose points tell no side is turned as its neighbour is.
std::vector<SectionCurve> join(std::vector<Piece> pieces) {
    struct Joint {
        bool turns; ///< one of both
        double distance;
        std::size_t a, b; ///< twice the piece, one more for its last point
    };
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    const auto at = [&](std::size_t end) -> const SectionPoint& {
        const Piece& piece = pieces[end / 2];
        return end % 2 == 0 ? piece.points.front() : piece.points.back();
    };
    std::vector<Joint> joints;
    for (std::size_t a = 0; a < 2 * pieces.size(); ++a)
        for (std::size_t b = a + 1; b < 2 * pieces.size(); ++b)
            if (const double far = base::distance(at(a).position, at(b).position);
                !pieces[a / 2].closed && !pieces[b / 2].closed && far < joined * at(a).unit &&
                (a / 2 != b / 2 || pieces[a / 2].points.size() > 2))
                joints.push_back({a % 2 == b % 2, far, a, b});
    std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) {
        return std::tie(a.turns, a.distance) < std::tie(b.turns, b.distance);
    });
    std::vector<std::size_t> mate(2 * pieces.size(), none);
    for (const Joint& joint : joints)
        if (mate[joint.a] == none && mate[joint.b] == none)
            mate[joint.a] = joint.b, mate[joint.b] = joint.a;
    std::vector<bool> done(pieces.size());
    std::vector<SectionCurve> out;
    const auto follow = [&](std::size_t first) { // an end that the curve begins with
        SectionCurve curve;
        curve.closed = pieces[first / 2].closed;
        for (std::size_t end = first; end != none; end = mate[end ^ 1]) {
            if (done[end / 2]) {
                curve.closed = true;
                break;
            }
            done[end / 2] = true;
            std::vector<SectionPoint>& points = pieces[end / 2].points;
            if (end % 2 == 1)
                turn(points);
            curve.points.insert(curve.points.end(), points.begin(), points.end());
            if (curve.closed)
                break;
        }
        out.push_back(std::move(curve));
    };
    for (std::size_t end = 0; end < mate.size(); ++end)
        if (mate[end] == none && !done[end / 2])
            follow(end);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece)
        if (!done[piece])
            follow(2 * piece);
    return out;
}

} // namespace

std::vector<SectionCurve> findSection(const Complex& complex, const Plane& plane, const base::Progress& progress,
                                      const surface::TraceOptions& options) {
    const base::CancelScope scope(progress.cancel);
    const std::size_t count = complex.cells().size();
    std::vector<std::vector<Vec3d>> crossings(count);
    std::vector<std::vector<Piece>> found(count);
    base::parallelFor(count, 1, [&](std::size_t c) {
        if (complex[static_cast<std::uint32_t>(c)].dimension == 1)
            crossings[c] = crossingsOf(complex, static_cast<std::uint32_t>(c), plane);
    });
    base::parallelFor(count, 1, [&](std::size_t c) {
        if (complex[static_cast<std::uint32_t>(c)].dimension == 2)
            found[c] = piecesOf(complex, static_cast<std::uint32_t>(c), plane, crossings, options);
    });
    std::vector<Piece> pieces;
    for (std::vector<Piece>& each : found)
        std::move(each.begin(), each.end(), std::back_inserter(pieces));
    std::vector<SectionCurve> out = join(std::move(pieces));
    std::stable_sort(out.begin(), out.end(),
                     [](const SectionCurve& a, const SectionCurve& b) { return a.length() > b.length(); });
    return out;
}

} // namespace complexes
