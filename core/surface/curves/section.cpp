#include "core/surface/curves/section.h"

#include "core/base/parallel.h"
#include "core/surface/curves/curve_tracing.h"
#include "core/surface/curves/traced_lines.h"
#include "core/surface/rays/ray_accept.h"

namespace surface {

using base::Plane, base::Vec3d, base::Vec3f;

namespace {

constexpr int maxIterations = 30;
constexpr double tolerance = 1e-12; ///< of the last step, in units of h
constexpr double longestStep = 0.3; ///< of Newton's, in units of h
constexpr double leastSine = 1e-3;  ///< of the angle between plane and surface: below it they touch
/// In units of h: surfels this near to the plane look for the section. The nearest to any place of the surface is a
/// spacing away, 0.29 h for supports of 38 neighbours.
constexpr double seedDistance = 0.3;
constexpr double seedReach = 1;   ///< in units of h: a curve farther off than that is another surfel's
constexpr double onCurve = 0.02;  ///< in units of h: how far a point may be from the polyline of its curve
constexpr double sameCurve = 0.1; ///< in units of h: two curves that are so close for half their way are one

bool usable(const Evaluationd& at) {
    return at.ok() || at.status == Status::BeyondBoundary;
}

/// Newton's iteration of the header: every iterate lies in the plane to rounding.
class SectionNewton {
  public:
    SectionNewton(const Surface& surface, const Plane& plane, const Vec3d& start, const OrientationHint& hint)
        : m_surface(surface), m_plane(plane), m_unoriented(!surface.tree().layout()->oriented), m_hint(hint) {
        moveTo(start);
    }

    SectionSearch run() {
        SectionSearch out;
        for (; usable(m_at); ++out.iterations) {
            const Vec3d& g = m_at.gradient;
            const Vec3d inPlane = g - m_plane.normal * dot(g, m_plane.normal);
            const double square = lengthSq(inPlane), unit = m_at.unit;
            out.status = Status::NotConverged;
            if (!(square > leastSine * leastSine * lengthSq(g)))
                return out;
            const Vec3d step = inPlane * (-m_at.value / square);
            const double size = length(step);
            if (!(size > std::max(tolerance * unit, 4e-16 * length(m_x)))) {
                if (std::isfinite(size) && std::abs(m_at.value) <= 1e-9 * unit) {
                    out.status = Status::Ok;
                    out.point = {m_x, base::normalized(g), base::normalized(cross(m_plane.normal, g)), unit};
                    out.surface = isSurface(m_at);
                }
                return out;
            }
            if (out.iterations == maxIterations)
                return out;
            if (!advance(size > longestStep * unit ? step * (longestStep * unit / size) : step))
                break;
        }
        out.status = m_at.status;
        return out;
    }

  private:
    bool advance(Vec3d step) {
        const Vec3d before = m_x;
        for (int halvings = 0; halvings < 8; ++halvings, step *= 0.5) {
            moveTo(before + step);
            if (usable(m_at))
                return true;
        }
        return false;
    }

    void moveTo(const Vec3d& x) {
        m_x = x - m_plane.normal * m_plane.distance(x);
        m_at = m_surface.evaluateReference(m_x, Need::Gradient, m_hint);
        if (m_unoriented && usable(m_at)) // keep the sign
            m_hint.direction = base::cast<float>(m_at.normal);
    }

    const Surface& m_surface;
    const Plane& m_plane;
    bool m_unoriented;
    OrientationHint m_hint; ///< the one given; for frames without a sign the last normal
    Vec3d m_x;
    Evaluationd m_at;
};

/// A SectionPoint that knows whether the surface reaches it.
struct Candidate : SectionPoint {
    bool surface = false;
};

struct SectionProblem {
    using Point = Candidate;
    const Surface& of;
    const Plane& plane;

    const Surface& surface() const { return of; }
    std::optional<Candidate> find(const Vec3d& start, const OrientationHint& hint) const {
        const SectionSearch found = findSectionPoint(of, plane, start, hint);
        return found.ok() ? std::optional(Candidate{found.point, found.surface}) : std::nullopt;
    }
    static bool holds(const Candidate& p) { return p.surface; }
};

} // namespace

std::vector<Vec3d> surfelsNear(const tree::SurfelTree& tree, const Plane& plane) {
    std::vector<Vec3d> out;
    const Vec3d& n = plane.normal;
    const auto reaches = [&](const base::Box3f& box, double support) {
        const Vec3d half = base::cast<double>(box.hi - box.lo) * 0.5;
        const double extent = std::abs(n.x) * half.x + std::abs(n.y) * half.y + std::abs(n.z) * half.z;
        return std::abs(plane.distance(base::cast<double>(box.centre()))) <= extent + seedDistance * support;
    };
    const auto walk = [&](const auto& self, const tree::Node& node) -> void {
        for (std::size_t i = 0; i < node.childCount; ++i) {
            const base::Box3f box{{node.loX[i], node.loY[i], node.loZ[i]}, {node.hiX[i], node.hiY[i], node.hiZ[i]}};
            if (!reaches(box, static_cast<double>(node.maxSupport[i])))
                continue;
            if (node.level > 1) {
                self(self, *node.nodes[i]);
                continue;
            }
            const surfel::SurfelBlock& block = *node.blocks[i];
            for (int slot = 0; slot < block.size(); ++slot) {
                const Vec3d p = base::cast<double>(block.position(slot));
                if (std::abs(plane.distance(p)) <= seedDistance * static_cast<double>(block.support(slot)))
                    out.push_back(p);
            }
        }
    };
    if (tree.root())
        walk(walk, *tree.root());
    return out;
}

namespace {

/// Points of the section near those surfels, in their order.
std::vector<Candidate> findSeeds(const Surface& surface, const Plane& plane, const base::Progress& progress) {
    const std::vector<Vec3d> starts = surfelsNear(surface.tree(), plane);
    constexpr std::size_t slab = 4096;
    std::vector<SectionSearch> found(starts.size());
    for (std::size_t from = 0; from < starts.size(); from += slab) {
        progress.step(0.5 * static_cast<double>(from) / static_cast<double>(starts.size()), "Looking for the section");
        base::parallelFor(std::min(slab, starts.size() - from), 16,
                          [&](std::size_t i) { found[from + i] = findSectionPoint(surface, plane, starts[from + i]); });
    }
    std::vector<Candidate> out;
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (found[i].ok() && found[i].surface &&
            distance(found[i].point.position, starts[i]) <= seedReach * found[i].point.unit)
            out.push_back({found[i].point, true});
    return out;
}

} // namespace

SectionSearch findSectionPoint(const Surface& surface, const Plane& plane, const Vec3d& start,
                               const OrientationHint& hint) {
    return SectionNewton(surface, plane, start, hint).run();
}

double SectionCurve::length() const {
    return arcLength(points, closed);
}

double SectionCurve::area(const Plane& plane) const {
    Vec3d sum;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += cross(points[i].position - points[0].position,
                     points[(i + 1) % points.size()].position - points[0].position);
    return 0.5 * dot(sum, plane.normal);
}

std::vector<SectionCurve> findSection(const Surface& surface, const Plane& plane, const base::Progress& progress,
                                      const TraceOptions& options) {
    std::vector<SectionCurve> out;
    const std::vector<Candidate> seeds = findSeeds(surface, plane, progress);
    TracedLines traced;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        if (i % 64 == 0)
            progress.step(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(seeds.size()),
                          "Following the section");
        if (traced.lineAt(seeds[i], onCurve) >= 0)
            continue;
        const auto curve = traceCurve(SectionProblem{surface, plane}, seeds[i], options);
        if (traced.sameAs(curve.points, sameCurve) >= 0)
            continue;
        traced.add(curve.points, curve.closed, lines++);
        if (curve.points.size() > 1)
            out.push_back({{curve.points.begin(), curve.points.end()}, curve.closed});
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const SectionCurve& a, const SectionCurve& b) { return a.length() > b.length(); });
    return out;
}

} // namespace surface
