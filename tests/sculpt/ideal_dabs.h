// Dabs whose exact inverse is known, so that a stroke can be compared with the deformation that it means: a point of
// the result, pulled back through all dabs, lies on the sphere that the stroke began with.
#pragma once

#include "core/sculpt/contact.h"
#include "core/sculpt/sampling.h"
#include "sculpt/dabs.h"
#include "support/registry.h"

namespace test {

/// p' = p + move W(|p* - centre| / R), p* = p for draw, half way for pulls; W smooth with a plateau.
struct IdealDab {
    base::Vec3d centre, move;
    double radius = 0, plateau = 0;
    bool halfWay = false;

    double weight(const base::Vec3d& at) const {
        const double r = distance(at, centre) / radius, t = std::clamp((r - plateau) / (1 - plateau), 0.0, 1.0);
        return 1 + t * t * (2 * t - 3);
    }
    /// The fixed point of w = W(q - move w) or W(q - move (w - 1) / 2 - move), which contracts for short moves.
    base::Vec3d pullBack(const base::Vec3d& q) const {
        double w = weight(q);
        for (int k = 0; k < 60; ++k) {
            const double next = weight(halfWay ? q - move * (0.5 * w + 0.5) : q - move * w);
            if (std::abs(next - w) < 1e-14)
                break;
            w = next;
        }
        return q - move * w;
    }
};

/// Does dabs to the unit sphere as a stroke does, resamples where it is due, and remembers what it did.
class IdealStroke {
  public:
    IdealStroke(std::size_t count, const base::Vec3f& begin) : m_start(surfaceOf(spherePoints(count))), m_now(m_start) {
        m_sampling.start(m_start, begin);
    }

    const surface::Surface& start() const { return m_start; }
    const surface::Surface& surface() const { return m_now; }
    const std::vector<IdealDab>& dabs() const { return m_dabs; }
    float spacing() const { return m_sampling.spacing(); }
    int resamplings() const { return m_resamplings; }
    /// Largest change of the surface by one resampling, in spacings.
    double pop() const { return m_pop; }

    /// A dab of draw at the surface below a place.
    void draw(const base::Vec3f& towards, float radius, float strength) {
        const auto at = sculpt::contact(m_now, {towards * 4.0f, -towards});
        if (!at)
            return;
        sculpt::Dab dab = dabOf(sculpt::tool("draw"), at->position, radius, strength);
        dab.areaNormal = sculpt::areaAround(m_now, *at, 0.5f * radius).normal;
        const base::Vec3d move = base::cast<double>(dab.areaNormal) * (0.05 * double(strength) * double(radius));
        apply("draw", dab, {base::cast<double>(dab.centre), move, double(radius), 0, false});
    }
    /// One step of a pull that holds what is at `centre`.
    void pull(const char* tool, const base::Vec3f& centre, const base::Vec3f& move, float radius, float plateau) {
        sculpt::Dab dab = dabOf(sculpt::tool(tool), centre, radius, 1);
        dab.move = move;
        dab.parameters["plateau"] = double(plateau);
        if (dab.parameters.contains("taper"))
            dab.parameters["taper"] = 0;
        apply(tool, dab, {base::cast<double>(centre), base::cast<double>(move), double(radius), double(plateau), true});
    }
    void finish() {
        if (m_sampling.pending())
            resampled(m_sampling.resample(m_now));
    }

    /// How far off the ideal shape a point of the surface lies, in spacings: first order.
    double off(const base::Vec3f& p) const {
        const base::Vec3d x = base::cast<double>(p);
        constexpr double e = 1e-5;
        const base::Vec3d slope{heightOf(x + base::Vec3d{e, 0, 0}) - heightOf(x - base::Vec3d{e, 0, 0}),
                                heightOf(x + base::Vec3d{0, e, 0}) - heightOf(x - base::Vec3d{0, e, 0}),
                                heightOf(x + base::Vec3d{0, 0, e}) - heightOf(x - base::Vec3d{0, 0, e})};
        return heightOf(x) / (length(slope) / (2 * e)) / double(spacing());
    }
    /// Is a place within reach of what the stroke did, `margin` around every dab?
    bool touched(const base::Vec3f& p, double margin) const {
        return std::any_of(m_dabs.begin(), m_dabs.end(), [&](const IdealDab& dab) {
            return distance(base::cast<double>(p), dab.centre + dab.move * 0.5) <
                   dab.radius + 0.5 * length(dab.move) + margin;
        });
    }

  private:
    double heightOf(base::Vec3d x) const {
        for (auto dab = m_dabs.rbegin(); dab != m_dabs.rend(); ++dab)
            x = dab->pullBack(x);
        return length(x) - 1;
    }
    void apply(const char* tool, const sculpt::Dab& dab, const IdealDab& ideal) {
        const tree::Edit edit = sculpt::tool(tool).apply(m_now, dab);
        m_sampling.note(m_now.tree(), edit, dab);
        m_now = {m_now.tree().apply(edit), m_now.definition()};
        m_dabs.push_back(ideal);
        if (m_sampling.due())
            resampled(m_sampling.resampleDue(m_now));
    }
    /// Random points of what was touched, on the surface before: how far off the one after are they?
    void resampled(const surface::Surface& next) {
        base::Random random(seed() + static_cast<unsigned long long>(m_resamplings++));
        std::vector<surfel::Surfel> near;
        for (const surfel::Surfel& each : m_now.tree().surfels().items)
            if (distance(base::cast<double>(each.position), m_dabs.back().centre) < 1.5 * m_dabs.back().radius)
                near.push_back(each);
        for (int k = 0; k < 100 && !near.empty(); ++k) {
            const surfel::Surfel& from = near[random.below(near.size())];
            const base::Vec3d aside = random.unitVector() * (0.5 * double(spacing()));
            const auto foot = surface::project(m_now, from.position + base::cast<float>(aside), {});
            const auto e = next.evaluate(foot.foot, surface::Need::Gradient, {foot.at.normal});
            const double slope = double(length(e.gradient));
            if (foot.ok() && foot.at.agreement > 0.6f)
                m_pop = std::max(m_pop,
                                 e.ok() && slope > 0.05 ? std::abs(double(e.value)) / slope / double(spacing()) : 99.0);
        }
        m_now = next;
    }

    surface::Surface m_start, m_now;
    sculpt::Sampling m_sampling;
    std::vector<IdealDab> m_dabs;
    int m_resamplings = 0;
    double m_pop = 0;
};

} // namespace test
