// f along one ray, as root finding asks for it: samples with transported signs, tolerances, a count. Internal to the
// room.
#pragma once

#include "core/surface/evaluation/source.h"
#include "core/surface/frames/frame_table.h"
#include "core/surface/rays/intersect.h"

namespace surface {

/// What all rays of a call have in common.
struct RaySetting {
    /// `refine` false: a sign change is enough.
    RaySetting(const Surface& surface_, const IntersectOptions& options_, bool refine_ = true)
        : surface(surface_), options(options_), refine(refine_), maxSupport(surface_.tree().maxSupport()),
          bounds(surface_.tree().bounds().inflated(maxSupport)) {
        const surfel::AttributeLayout& layout = *surface.tree().layout();
        oriented = layout.normals && layout.oriented;
        any = !surface.tree().empty() && surface.definition().manifold == Manifold::Surface;
        trace = !options.robust && rowOf(surface.effectiveFrame()).distance;
        discs = trace && oriented;
        if (!refine)
            options.tolerance = std::max(options.tolerance, 0.02);
    }

    /// How far discs are looked for: the one that leads to a root may be crossed behind it.
    float discMost() const { return options.tMax + maxSupport; }

    const Surface& surface;
    IntersectOptions options;
    bool refine;
    bool any;      ///< may rays hit at all?
    bool oriented; ///< do the surfels' normals give f a sign?
    bool trace;    ///< fast, and |f| is like a distance (the frame's row says so)
    bool discs;    ///< fast, from discs
    float maxSupport;
    base::Box3f bounds; ///< where f is defined; rays that start outside meet discs before the surface
};

/// Where the evaluations of a ray find their surfels: first guesses of a packet of rays share one neighbourhood, steps
/// along a ray collect their own.
struct RaySources {
    explicit RaySources(const Surface& surface) : guesses(surface, Steps::Apart), steps(surface, Steps::Close) {}
    Source guesses, steps;
    /// Room for one evaluation: making one anew takes longer than much of what is done with it.
    template <class T>
    Evaluation<T>& scratch() {
        if constexpr (std::is_same_v<T, float>)
            return m_single;
        else
            return m_double;
    }

  private:
    Evaluation<float> m_single;
    Evaluation<double> m_double;
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
    RayProbe(const RaySetting& setting, RaySources& sources, const base::Ray<T>& ray)
        : m_setting(setting), m_sources(sources), m_origin(base::cast<double>(ray.origin)),
          m_direction(base::normalized(base::cast<double>(ray.direction))) {}

    const RaySetting& setting() const { return m_setting; }
    bool inRange(double t) const { return t >= double(m_setting.options.tMin) && t <= double(m_setting.options.tMax); }
    double mostT() const { return double(m_setting.options.tMax); }
    const base::Vec3d& direction() const { return m_direction; }
    base::Vec3d position(double t) const { return m_origin + m_direction * t; }
    base::Rayf rounded() const { return {base::cast<float>(m_origin), base::cast<float>(m_direction)}; }
    /// Evaluations since the last call.
    int takeEvaluations() { return std::exchange(m_evaluations, 0); }

    /// Around the first guess: no neighbourhood is collected but the packet's. Good until the next call.
    const Evaluation<T>& guess(double t) {
        ++m_evaluations;
        Evaluation<T>& out = m_sources.template scratch<T>();
        if constexpr (std::is_same_v<T, float>)
            m_sources.guesses.evaluate(base::cast<T>(position(t)), Need::Gradient, {}, out);
        else
            out = m_sources.guesses.evaluate(base::cast<T>(position(t)), Need::Gradient);
        return out;
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
        if (m_setting.oriented || !other.usable() || !s.usable())
            return;
        s.sign = dot(s.at.normal, other.at.normal) * other.sign < T(0) ? T(-1) : T(1);
    }

    /// Lengths that count as nothing: what the precision of f and of positions leaves.
    double precision(const Evaluation<T>& at, double t) const {
        constexpr double ofUnit = std::is_same_v<T, float> ? 1e-6 : 1e-12;
        const double rounding = 4 * double(std::numeric_limits<T>::epsilon()) * length(position(t));
        const double along = 4 * std::numeric_limits<double>::epsilon() * std::max(length(m_origin), std::abs(t));
        return std::max({ofUnit * double(at.unit), rounding, along});
    }
    /// How close to the root is close enough.
    double tolerance(const Evaluation<T>& at, double t) const {
        return std::max(m_setting.options.tolerance * double(at.unit), precision(at, t));
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

    const RaySetting& m_setting;
    RaySources& m_sources;
    base::Vec3d m_origin, m_direction;
    double m_end = 0, m_unit = 0;
    int m_evaluations = 0;
};

} // namespace surface
