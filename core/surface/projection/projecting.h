// The iteration of projections for one position, in float and in double (surface/README 3.2, 3.3). Internal to the
// room.
#pragma once

#include "core/surface/projection/descent.h"
#include "core/surface/projection/feet_together.h"
#include "core/surface/projection/foot_step.h"
#include "core/surface/projection/restarts.h"
#include "core/surfel/shape.h"

#include <algorithm>
#include <optional>

namespace surface {

/// From here on single precision hands over to double: what takes that long is nearly as far from two feet, and only
/// the same arithmetic as the reference's is sure to choose the same.
constexpr int hardAfter = 8;

/// Where a projection goes down the surface, Newton's steps are tried anew after so many.
constexpr int stepsDown = 4;

template <class T>
class Projecting {
  public:
    Projecting(Source& source, const base::Vec3<T>& x0, const ProjectOptions& options, const OrientationHint& hint)
        : m_source(source), m_options(options), m_given(hint), m_x0(x0), m_tolerance(toleranceOf<T>(options)) {}

    Projection<T> run() { return runFrom(m_x0); }
    /// The same from where steps in lanes have led, or ended.
    Projection<float> run(const LaneFoot& foot) {
        m_iterations = foot.soFar.iterations;
        m_evaluations = foot.soFar.evaluations;
        if (foot.end == LaneFoot::End::Found)
            return finished(foot.soFar);
        return runFrom(foot.end == LaneFoot::End::Resume ? foot.soFar.foot : m_x0);
    }

  private:
    static constexpr bool exact = std::is_same_v<T, double>;
    static constexpr T epsilon = std::numeric_limits<T>::epsilon();
    static bool usable(const Evaluation<T>& e) { return e.ok() || e.status == Status::BeyondBoundary; }
    static bool found(const Projection<T>& p) { return p.ok() || p.status == Status::BeyondBoundary; }
    bool orthogonal() const { return m_options.projector == Projector::Orthogonal; }
    bool basic() const { return m_options.projector == Projector::Basic; }

    Projection<T> runFrom(const base::Vec3<T>& y) {
        begin(y);
        return finished(usable(m_at) ? iterate() : result(m_at.status));
    }
    /// Where there is no foot, or another must be nearer, the others are tried.
    Projection<T> finished(const Projection<T>& found) {
        const Projection<T> out = m_hard || settledNear(found) ? found : restarted(found);
        if constexpr (exact) {
            if (orthogonal() && out.status == Status::NotConverged)
                return descended(out);
        } else if (m_hard) {
            return inDouble();
        }
        return out;
    }

    // --- one iteration

    void begin(const base::Vec3<T>& y) {
        m_hint = m_given;
        m_y = y;
        m_steps = m_slow = m_idle = 0;
        m_damping = 1;
        m_least = std::numeric_limits<T>::infinity();
        evaluate(plainNeed());
    }

    Projection<T> iterate() {
        for (;;) {
            if (m_need < plainNeed()) {
                if (valueSuffices())
                    return settled();
                evaluate(plainNeed());
            }
            const Iterate<T> here = iterateHere();
            const base::Vec3<T> step = stepFrom(here);
            const T size = length(step);
            if (size <= smallest())
                return settled();
            if (m_steps == (exact ? m_options.maxIterations : std::min(hardAfter, m_options.maxIterations)) ||
                !gains(size))
                break;
            damp(size);
            m_last = here;
            m_lastStep = step * m_damping;
            m_lastSize = size;
            ++m_steps;
            ++m_iterations;
            if (!advance(needAfter(size)))
                return result(m_at.status);
        }
        m_hard = !exact && m_steps < m_options.maxIterations;
        return result(Status::NotConverged);
    }

    Need plainNeed() const { return orthogonal() || (exact && !basic()) ? Need::Gradient : Need::Value; }

    /// Derivatives of the step's direction pay near the end (double), and where some steps have not led there (float).
    Need needAfter(T size) const {
        const Need last = size < T(1e-3) * m_at.unit ? m_options.need : Need::Value; // it may be the foot
        if (basic())
            return last;
        if (orthogonal() && !exact && m_options.need == Need::Value && staysParallel())
            return Need::Value;
        const bool newton = exact ? size < T(shortStep) * m_at.unit || m_steps >= 6 : m_steps >= 3;
        return std::max(last, !newton ? plainNeed() : orthogonal() ? Need::Hessian : Need::Gradient);
    }

    /// Whether the last step will hardly turn the gradient: as far as n's derivative tells, and the angle between the
    /// two, which changes over lengths of h. Then a value may do to see that the step has led to a foot.
    bool staysParallel() const {
        const T turn = length(m_at.normalGradient * m_lastStep);
        const T tilt = length(cross(m_at.gradient, m_at.normal)) * length(m_lastStep) / m_at.unit;
        return (turn + tilt) * length(m_x0 - m_y - m_lastStep) <= smallest();
    }
    /// Whether it has: f vanishes and n has not turned.
    bool valueSuffices() const {
        return std::abs(m_at.value) <= smallest() &&
               distance(m_at.normal, m_lastNormal) * length(m_x0 - m_y) <= smallest();
    }

    void evaluate(Need need) {
        m_lastNormal = m_at.normal;
        ++m_evaluations;
        m_need = need;
        m_at = m_source.evaluate(m_y, need, m_hint);
        if (usable(m_at) && m_unoriented && lengthSq(m_given.direction) == 0) // keep the sign
            m_hint.direction = base::cast<float>(m_at.normal);
    }

    /// Last step that counts as standing still: the tolerance, but not below what positions can tell apart, nor below
    /// what the last bits of the direction do to the foot of a distant position.
    T smallest() const {
        const T size = std::max({std::abs(m_y.x), std::abs(m_y.y), std::abs(m_y.z)});
        const T afar = basic() ? T(0) : length(m_x0 - m_y);
        return std::max(m_tolerance * m_at.unit, epsilon * (size + T(4) * afar));
    }

    Iterate<T> iterateHere() const {
        const bool flat = m_need == Need::Value || !(lengthSq(m_at.gradient) > T(1e-4)); // says nothing: go by n
        Iterate<T> out;
        out.back = basic() ? base::Vec3<T>{} : m_x0 - m_y;
        out.along = orthogonal() && !flat ? m_at.gradient : m_at.normal;
        out.slope = flat ? m_at.normal * slopeAlongNormal() : m_at.gradient;
        if (!(std::abs(dot(out.slope, out.along)) > T(0.1) * length(out.along)))
            out.slope = m_at.normal;
        if (!flat && fades())
            out.slope = base::normalized(out.along);
        out.value = m_at.value;
        out.unit = m_at.unit;
        out.meet();
        return out;
    }

    /// Whether f is flatter here than on the way to the surface: above near sheets, where the farther one comes into
    /// play. A step by its slope would lead past both.
    bool fades() const {
        return std::abs(m_at.value) > T(fadesFrom) * m_at.unit && dot(m_at.gradient, m_at.normal) < T(fadesBelow);
    }

    /// The slope of f along n, as the last step of a basic projection has shown it (secant).
    T slopeAlongNormal() const {
        if (!basic() || m_steps == 0)
            return 1;
        const T gone = dot(m_lastStep, m_last.slope); // what f would have lost on the plane there
        return std::clamp((m_last.value - m_at.value) / -gone * length(m_last.slope), T(0.5), T(2));
    }

    base::Vec3<T> stepFrom(const Iterate<T>& here) const {
        if (basic())
            return here.plain();
        const bool derivative = orthogonal() ? m_need == Need::Hessian : m_need >= Need::Gradient;
        if (derivative) {
            const base::Vec3<T> out = newton(here, orthogonal() ? m_at.hessian : m_at.normalGradient);
            if (lengthSq(out) > T(0))
                return out;
        }
        base::Vec3<T> out;
        if (m_need != Need::Value && !derivative && guardedBySeries(here, m_at.normalGradient, bendFactor(), out))
            return out;
        const bool learns = m_steps > 0 && !derivative && alongSurface(m_lastStep, here.along);
        if (m_need == Need::Value && !learns)
            return guarded(here);
        TangentMatrix<T> w(base::normalized(here.along));
        if (m_need != Need::Value)
            w.add(derivative ? bend() : m_at.normalGradient * bendFactor(), here.parts);
        if (learns)
            w.learn(m_lastStep, m_last.plain() - here.plain());
        return guarded(here, w);
    }
    /// Whether at least half of a step is, so that it tells how the direction turns there.
    static bool alongSurface(const base::Vec3<T>& step, const base::Vec3<T>& direction) {
        const T across = dot(step, direction);
        return across * across < T(0.75) * lengthSq(step) * lengthSq(direction);
    }
    /// The gradient turns about as the frame's normal does.
    T bendFactor() const { return orthogonal() ? length(m_at.gradient) : T(1); }
    const base::Mat3<T>& bend() const { return orthogonal() ? m_at.hessian : m_at.normalGradient; }

    /// Whether steps still shrink. Where f jumps (overlapping scans, sheets told apart) they go round in circles.
    bool gains(T size) {
        m_idle = size < T(0.9) * m_least ? 0 : m_idle + 1;
        m_least = std::min(m_least, size);
        return m_idle < 12;
    }

    /// Oscillation damping: after two steps in a row that hardly shrank half as far, until they shrink.
    void damp(T size) {
        m_slow = m_steps > 0 && size > T(0.9) * m_lastSize ? m_slow + 1 : 0;
        if (m_slow >= 2) {
            m_damping *= T(0.5);
            m_slow = 0;
        } else if (m_steps > 0 && size < T(0.6) * m_lastSize) {
            m_damping = std::min(T(1), T(2) * m_damping);
        }
    }

    /// Goes by the last step, or part of it where the point there has no surface to speak of.
    bool advance(Need need) {
        const base::Vec3<T> y = m_y;
        for (int halvings = 0; halvings < 8; ++halvings, m_lastStep *= T(0.5)) {
            m_y = y + m_lastStep;
            evaluate(need);
            if (usable(m_at))
                return true;
        }
        return false;
    }

    // --- ends

    Projection<T> settled() {
        if (std::abs(m_at.value) > T(10) * smallest())
            return result(Status::NotConverged);
        if (m_options.need > m_need)
            evaluate(m_options.need);
        if (m_at.status == Status::BeyondBoundary)
            return result(m_options.checkBoundary ? Status::BeyondBoundary : Status::Ok);
        return result(m_at.status);
    }

    Projection<T> result(Status status) const { return {status, m_y, m_at, m_iterations, m_evaluations}; }

    // --- recovery (surface/README 3.3)

    /// Whether there is a foot, and for closest points not so far that another must be nearer.
    bool settledNear(const Projection<T>& p) {
        if (!found(p))
            return false;
        if (!orthogonal() || distance(m_x0, p.foot) <= T(0.5) * p.at.unit)
            return true;
        return distance(m_x0, p.foot) <= static_cast<T>(restarts().nearest()) + T(0.25) * p.at.unit;
    }

    Restarts& restarts() {
        if (!m_restarts)
            m_restarts.emplace(m_source.surface().tree(), base::cast<float>(m_x0));
        return *m_restarts;
    }

    /// From the nearest surfels, seen in different directions from x0, until a foot is near.
    Projection<T> restarted(Projection<T> best) {
        constexpr int most = 4;
        bool first = true;
        for (int tries = 0; tries < most; ++tries) {
            const T limit = found(best) ? distance(m_x0, best.foot) : std::numeric_limits<T>::infinity();
            const tree::Neighbour* start = restarts().next(static_cast<float>(limit));
            if (!start)
                break;
            const Projection<T> out = from(*start);
            restarts().tried(*start, found(out));
            if (better(out, best) || (first && !found(best)))
                best = out;
            first = false;
            if (m_hard || settledNear(best))
                break;
        }
        best.iterations = m_iterations;
        best.evaluations = m_evaluations;
        return best;
    }

    /// Down the surface, from x0 or else from the nearest surfel, to where Newton's steps lead to a foot.
    Projection<T> descended(const Projection<T>& failed) {
        Projection<T> out = failed;
        std::vector<tree::Neighbour> near;
        m_source.surface().tree().nearest(base::cast<float>(m_x0), 1, near);
        if (near.empty())
            return failed;
        const base::Vec3<T> surfel = base::cast<T>(near[0].block->position(near[0].slot));
        for (const base::Vec3<T>& from : {m_x0, surfel}) {
            Descent<T> way(m_source, m_x0, m_given, m_tolerance);
            for (bool on = way.start(from); on && !found(out);) {
                for (int k = 0; k < stepsDown && on; ++k)
                    on = way.step();
                begin(way.place());
                if (const Projection<T> end = iterate(); found(end) && distance(end.foot, way.place()) < m_at.unit)
                    out = end;
            }
            m_evaluations += way.evaluations();
            if (found(out))
                break;
        }
        out.iterations = m_iterations;
        out.evaluations = m_evaluations;
        return out;
    }

    bool better(const Projection<T>& a, const Projection<T>& b) const {
        if (!found(a) || !found(b))
            return found(a);
        if (a.ok() != b.ok())
            return a.ok();
        return distanceSq(m_x0, a.foot) < distanceSq(m_x0, b.foot);
    }

    /// On the tangent plane of a surfel, within 0.9 of its support; where even that is of no use, at the surfel.
    Projection<T> from(const tree::Neighbour& start) {
        const surfel::SurfelBlock& block = *start.block;
        const base::Vec3<T> p = base::cast<T>(block.position(start.slot));
        const base::Vec3<T> n = base::cast<T>(block.normal(start.slot));
        const T reach = T(0.9) * static_cast<T>(block.support(start.slot));
        base::Vec3<T> offset = lengthSq(n) > T(0) ? m_x0 - p - n * dot(n, m_x0 - p) : base::Vec3<T>{};
        const int shape = surfel::shapeChannel(*m_source.surface().tree().layout());
        const T along = dot(base::cast<T>(surfel::shapeOf(block, start.slot, shape)), offset);
        const T away = std::sqrt(lengthSq(offset) + along * along);
        if (away > reach)
            offset *= reach / away;
        begin(p + offset);
        if (!usable(m_at))
            begin(p);
        return usable(m_at) ? iterate() : result(m_at.status);
    }

    /// The same in double. REQUIRES: T is float.
    Projection<T> inDouble() {
        ProjectOptions options = m_options;
        options.tolerance = std::max(1e-8, options.tolerance);
        options.need = Need::Value;
        const Projection<double> there = Projecting<double>(m_source, base::cast<double>(m_x0), options, m_given).run();
        m_iterations += there.iterations;
        m_evaluations += there.evaluations;
        m_y = base::cast<T>(there.foot);
        if (there.status == Status::Outside || there.status == Status::Degenerate)
            return result(there.status);
        evaluate(std::max(plainNeed(), m_options.need));
        return result(usable(m_at) ? there.status : m_at.status);
    }

    Source& m_source;
    const ProjectOptions& m_options;
    const OrientationHint& m_given;
    OrientationHint m_hint; ///< the one given; for unoriented frames else the last normal
    const bool m_unoriented = !m_source.surface().tree().layout()->oriented;
    base::Vec3<T> m_x0, m_y;
    T m_tolerance;
    Evaluation<T> m_at; ///< at m_y
    Need m_need = Need::Value;
    Iterate<T> m_last; ///< before the last step
    base::Vec3<T> m_lastStep, m_lastNormal;
    T m_lastSize = 0, m_damping = 1, m_least = 0;
    int m_steps = 0, m_slow = 0, m_idle = 0; ///< of this start
    int m_iterations = 0, m_evaluations = 0;
    bool m_hard = false;
    std::optional<Restarts> m_restarts;
};

} // namespace surface
