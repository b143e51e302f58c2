#include "core/surface/project.h"

#include "core/surface/packets.h"

#include <algorithm>
#include <cassert>

namespace surface {

namespace {

constexpr float packetSlack = 0.3f; ///< of h, around a packet: most feet lie within it

/// The iteration of alg. 3.1 for one position.
template <class T>
class Projecting {
  public:
    Projecting(Source& source, const base::Vec3<T>& x0, const ProjectOptions& options, const Hint& hint)
        : m_source(source), m_options(options), m_hint(hint), m_x0(x0),
          m_tolerance(options.tolerance > 0      ? options.tolerance
                      : std::is_same_v<T, float> ? 1e-6
                                                 : 1e-12) {}

    Projection<T> run() {
        m_y = m_x0;
        m_at = evaluate(m_y);
        if (!usable(m_at) && !recover())
            return result(m_at.status);
        for (m_iterations = 1; m_iterations <= m_options.maxIterations; ++m_iterations) {
            const base::Vec3<T> way = target() - m_y;
            if (length(way) <= smallest())
                return settled();
            relax(way);
            const base::Vec3<T> step = way * m_relaxation;
            if (!advance(m_y + step))
                return result(m_at.status);
        }
        m_iterations = m_options.maxIterations;
        return result(Status::NotConverged);
    }

  private:
    static bool usable(const Evaluation<T>& e) { return e.ok() || e.status == Status::BeyondBoundary; }

    Need iterationNeed() const { return m_options.projector == Projector::Orthogonal ? Need::Gradient : Need::Value; }
    Evaluation<T> evaluate(const base::Vec3<T>& y) const { return m_source.evaluate(y, iterationNeed(), m_hint); }

    /// Last step that counts as standing still: the tolerance, but not below what positions can tell apart, nor below
    /// what the last bits of the direction do to the foot of a distant position.
    T smallest() const {
        constexpr T epsilon = std::numeric_limits<T>::epsilon();
        const T size = std::max({std::abs(m_y.x), std::abs(m_y.y), std::abs(m_y.z)});
        const T afar = m_options.projector == Projector::Basic ? T(0) : length(m_x0 - m_y);
        return std::max(static_cast<T>(m_tolerance) * m_at.unit, epsilon * (T(2) * size + T(8) * afar));
    }

    /// Where the plane at y sends the base point b: b - v (f + v'.(b - y)) / (v.v'), along v = n or g. Linearising f
    /// by its own gradient gives orthogonal projection the fixed points of alg. 3.1, {f = 0, x0 - y along g}, and
    /// Newton's rate towards the surface.
    base::Vec3<T> target() const {
        const base::Vec3<T>& b = m_options.projector == Projector::Basic ? m_y : m_x0;
        const base::Vec3<T>& n = m_at.normal;
        if (m_options.projector != Projector::Orthogonal)
            return b - n * (m_at.value + dot(n, b - m_y));
        const base::Vec3<T>& g = m_at.gradient;
        const T slopeSq = lengthSq(g);
        if (!(slopeSq > T(1e-4))) // a gradient that says nothing: go along n, the next point may be better
            return b - n * (m_at.value + dot(n, b - m_y));
        return b - g * ((m_at.value + dot(g, b - m_y)) / slopeSq);
    }

    /// Chooses the part of the way to go. Tangentially the plain iteration multiplies the error by e kappa (alg. 3.1),
    /// which two ways in a row tell (Irons & Tuck 1969); after two that hardly shrank the most allowed is halved, since
    /// any part below 2/(1 + e kappa) converges.
    void relax(const base::Vec3<T>& way) {
        const T distance = length(way), last = length(m_lastWay);
        if (m_iterations > 1 && m_options.projector != Projector::Basic) {
            const base::Vec3<T> change = way - m_lastWay;
            const T changeSq = lengthSq(change);
            if (changeSq > T(0))
                m_relaxation *= -dot(m_lastWay, change) / changeSq;
            m_slow = distance > T(0.9) * last ? m_slow + 1 : 0;
            if (m_slow >= 2) {
                m_most *= T(0.5);
                m_slow = 0;
            }
            m_relaxation = std::clamp(m_relaxation, std::min(T(0.1), m_most), m_most);
        }
        m_lastWay = way;
    }

    /// Goes to y1, or part of the way where y1 has no surface to speak of.
    bool advance(base::Vec3<T> y1) {
        for (int halvings = 0; halvings < 8; ++halvings) {
            const Evaluation<T> at = evaluate(y1);
            if (usable(at)) {
                m_y = y1;
                m_at = at;
                return true;
            }
            m_failure = at;
            y1 = (m_y + y1) * T(0.5);
        }
        m_at = m_failure;
        return false;
    }

    /// Outside all supports (alg. 3.1.3): on to the tangent plane of the nearest surfel, within 0.9 of its support;
    /// where even that is of no use, to the surfel itself.
    bool recover() {
        std::vector<tree::Neighbour> nearest;
        m_source.surface().tree().nearest(base::cast<float>(m_x0), 1, nearest);
        if (nearest.empty())
            return false;
        const surfel::SurfelBlock& block = *nearest[0].block;
        const base::Vec3<T> p = base::cast<T>(block.position(nearest[0].slot));
        const base::Vec3<T> n = base::cast<T>(block.normal(nearest[0].slot));
        const T reach = T(0.9) * static_cast<T>(block.support(nearest[0].slot));
        base::Vec3<T> offset = m_x0 - p - n * dot(n, m_x0 - p);
        if (lengthSq(n) == T(0))
            offset = {};
        const T away = length(offset);
        if (away > reach)
            offset *= reach / away;
        for (const base::Vec3<T>& start : {p + offset, p}) {
            m_at = evaluate(start);
            m_y = start;
            if (usable(m_at))
                return true;
        }
        return false;
    }

    Projection<T> settled() {
        if (std::abs(m_at.value) > T(10) * smallest())
            return result(Status::NotConverged);
        if (m_options.need > iterationNeed())
            m_at = m_source.evaluate(m_y, m_options.need, m_hint);
        if (m_at.status == Status::BeyondBoundary)
            return result(m_options.checkBoundary ? Status::BeyondBoundary : Status::Ok);
        return result(m_at.status);
    }

    Projection<T> result(Status status) const { return {status, m_y, m_at, m_iterations}; }

    Source& m_source;
    const ProjectOptions& m_options;
    const Hint& m_hint;
    base::Vec3<T> m_x0, m_y;
    double m_tolerance;
    Evaluation<T> m_at, m_failure;
    base::Vec3<T> m_lastWay;
    T m_relaxation = 1, m_most = T(1.5);
    int m_slow = 0, m_iterations = 0;
};

} // namespace

Projection<float> project(const Surface& surface, const base::Vec3f& x, const ProjectOptions& options,
                          const Hint& hint) {
    Source source(surface);
    return Projecting<float>(source, x, options, hint).run();
}

Projection<double> projectReference(const Surface& surface, const base::Vec3d& x, const ProjectOptions& options,
                                    const Hint& hint) {
    Source source(surface);
    return Projecting<double>(source, x, options, hint).run();
}

void project(const Surface& surface, std::span<const base::Vec3f> x, const ProjectOptions& options,
             std::span<Projection<float>> out) {
    assert(x.size() == out.size());
    const Hint none;
    forPackets(surface, x, packetSlack,
               [&](Source& source, std::size_t i) { out[i] = Projecting<float>(source, x[i], options, none).run(); });
}

} // namespace surface
