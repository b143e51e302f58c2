// f along one ray, as root finding asks for it: samples with transported signs, tolerances, a count. Internal to the
// room.
#pragma once

#include "core/surface/intersect.h"
#include "core/surface/source.h"

namespace surface {

/// Spacing in units of h at the default of 38 neighbours: h = 3.5 s (alg. 2.6).
constexpr double spacingOfUnit = 1 / 3.5;

/// Where the evaluations of a ray find their surfels: first guesses of a packet of rays share one neighbourhood, steps
/// along a ray collect their own.
struct RaySources {
    explicit RaySources(const Surface& surface) : guesses(surface, Steps::Apart), steps(surface, Steps::Close) {}
    Source guesses, steps;
};

template <class T>
struct RaySample {
    double t = 0;
    Evaluation<T> at;
    T sign = 1; ///< transported along the ray where the frame has none of its own

    bool usable() const { return at.ok() || at.status == Status::BeyondBoundary; }
    double f() const { return static_cast<double>(sign * at.value); }
    /// Slope of f along the direction d, by the plane.
    double slope(const base::Vec3d& d) const { return dot(base::cast<double>(at.normal), d) * double(sign); }
};

/// `t` is double in both precisions: positions are rounded once, where f is asked for.
template <class T>
class RayProbe {
  public:
    RayProbe(RaySources& sources, const base::Ray<T>& ray, const IntersectOptions& options)
        : m_sources(sources), m_origin(base::cast<double>(ray.origin)),
          m_direction(base::normalized(base::cast<double>(ray.direction))), m_options(options),
          m_oriented(surface().tree().layout()->normals && surface().tree().layout()->oriented) {}

    const Surface& surface() const { return m_sources.steps.surface(); }
    const IntersectOptions& options() const { return m_options; }
    bool oriented() const { return m_oriented; }
    const base::Vec3d& direction() const { return m_direction; }
    base::Vec3d position(double t) const { return m_origin + m_direction * t; }
    base::Rayf rounded() const { return {base::cast<float>(m_origin), base::cast<float>(m_direction)}; }
    /// Evaluations since the last call.
    int takeEvaluations() { return std::exchange(m_evaluations, 0); }

    /// Around the first guess: no neighbourhood is collected but the packet's.
    RaySample<T> guess(double t) {
        ++m_evaluations;
        return {t, m_sources.guesses.evaluate(base::cast<T>(position(t)), Need::Gradient), T(1)};
    }
    /// Says how far ahead samples will be asked for, and in what unit of h.
    void expect(double end, double unit) {
        m_end = end;
        m_unit = unit;
    }
    RaySample<T> sample(double t, Need need = Need::Value) {
        collectAhead(t);
        ++m_evaluations;
        return {t, m_sources.steps.evaluate(base::cast<T>(position(t)), need), T(1)};
    }
    /// A sample whose normal looks to the same side as that of a neighbour on the ray.
    RaySample<T> sampleBeside(const RaySample<T>& other, double t) {
        RaySample<T> out = sample(t);
        align(other, out);
        return out;
    }
    void align(const RaySample<T>& other, RaySample<T>& s) const {
        if (m_oriented || !other.usable() || !s.usable())
            return;
        s.sign = dot(s.at.normal, other.at.normal) * other.sign < T(0) ? T(-1) : T(1);
    }

    /// Lengths that count as nothing: what the precision of f and of positions leaves.
    double precision(const Evaluation<T>& at, double t) const {
        constexpr double ofUnit = std::is_same_v<T, float> ? 1e-6 : 1e-12;
        const double rounding = 4 * double(std::numeric_limits<T>::epsilon()) * length(position(t));
        return std::max(ofUnit * double(at.unit), rounding);
    }
    /// How close to the root is close enough.
    double tolerance(const Evaluation<T>& at, double t) const {
        return std::max(m_options.tolerance * double(at.unit), precision(at, t));
    }

  private:
    /// What the next steps will ask for, collected at once.
    void collectAhead(double t) {
        if constexpr (std::is_same_v<T, float>) {
            constexpr double reach = 1.5, slack = 0.15; // of h, along the ray and around it
            const base::Vec3f here = base::cast<float>(position(t));
            if (m_sources.steps.covers(here))
                return;
            base::Box3f box{here, here};
            box.extend(base::cast<float>(position(std::min(t + reach * m_unit, m_end))));
            m_sources.steps.expect(box.inflated(static_cast<float>(slack * m_unit)));
        }
    }

    RaySources& m_sources;
    base::Vec3d m_origin, m_direction;
    const IntersectOptions& m_options;
    bool m_oriented;
    double m_end = 0, m_unit = 0;
    int m_evaluations = 0;
};

} // namespace surface
