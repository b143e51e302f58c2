// The short ones: dots, airbrush, anchored, line; and which is which.
#include "core/sculpt/stroke/stroke_methods.h"
#include "core/sculpt/stroke/stroke_entrance.h"

#include <cmath>

namespace sculpt {

namespace {

class Dots : public Method {
  public:
    explicit Dots(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool moved) override {
        if (!moved)
            return;
        if (const auto touched = m_dabs.contact(sample.ray))
            m_dabs.dabAt(sample, *touched, m_dabs.form(sample));
    }

  private:
    Dabs& m_dabs;
};

class Airbrush : public Method {
  public:
    explicit Airbrush(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool moved) override;

  private:
    void follow(const StrokeSample& to);

    Dabs& m_dabs;
    std::optional<StrokeSample> m_before, m_previous; ///< that met nothing; from the first contact on
    double m_begin = 0, m_made = 0;                   ///< seconds; dabs that are due since then, also those that missed
};

void Airbrush::add(const StrokeSample& sample, bool) {
    if (!m_previous) {
        const auto in = entranceBetween(m_dabs, m_before, sample);
        m_before = sample;
        if (!in)
            return;
        m_dabs.dabAt(in->sample, in->contact, m_dabs.form(in->sample));
        m_begin = double(in->sample.seconds);
        m_previous = in->sample;
    }
    follow(sample);
    m_previous = sample;
}

void Airbrush::follow(const StrokeSample& to) {
    const double from = double(m_previous->seconds), span = double(to.seconds) - from;
    // A place in time is due where it is reached up to rounding: samples may fall right on it.
    const double rate = double(m_dabs.settings().rate), reached = (double(to.seconds) - m_begin) * rate + 1e-3;
    for (int probes = 0; m_made + double(to.stride) <= reached && probes < mostProbes; ++probes) {
        m_made += double(to.stride);
        const double u = span > 0 ? (m_begin + m_made / rate - from) / span : 1;
        const StrokeSample sample = between(*m_previous, to, static_cast<float>(std::clamp(u, 0.0, 1.0)));
        if (const auto touched = m_dabs.contact(sample.ray))
            m_dabs.dabAt(sample, *touched, m_dabs.form(sample));
    }
    m_made = std::max(m_made, std::floor(reached - double(to.stride))); // none later than asked
}

/// The first place on the straight way between two samples that meets the model: what lies between has no say.
std::optional<Entrance> firstBetween(const Dabs& dabs, const StrokeSample& from, const StrokeSample& to) {
    constexpr int steps = 256;
    for (int k = 1; k <= steps; ++k)
        if (auto found = entranceAt(dabs, between(from, to, float(k) / steps))) {
            float out = float(k - 1) / steps, in = float(k) / steps;
            for (int halving = 0; halving < 10; ++halving) {
                const float middle = 0.5f * (out + in);
                const auto there = entranceAt(dabs, between(from, to, middle));
                (there ? in : out) = middle;
                if (there)
                    found = there;
            }
            return found;
        }
    return {};
}

class Anchored : public Method {
  public:
    explicit Anchored(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool moved) override;

  private:
    Dabs& m_dabs;
    std::optional<StrokeSample> m_first;
    std::optional<Entrance> m_start; ///< the first sample, where it meets the model
};

void Anchored::add(const StrokeSample& sample, bool) {
    if (!m_first) {
        m_first = sample;
        m_start = entranceAt(m_dabs, sample);
        if (m_start)
            m_dabs.begin(m_start->contact);
        return;
    }
    m_dabs.restart();
    const std::optional<Entrance> anchor = m_start ? m_start : firstBetween(m_dabs, *m_first, sample);
    if (!anchor)
        return;
    const base::Vec3f& plane = anchor->sample.ray.direction;
    const float facing = dot(sample.ray.direction, plane),
                t = dot(anchor->contact.position - sample.ray.origin, plane) / facing;
    if (!(facing > 0.05f) || !(t > 0) || !std::isfinite(t))
        return;
    Dabs::Form form = m_dabs.form(sample);
    form.upwards = sample.ray.at(t) - anchor->contact.position;
    form.radius = length(form.upwards);
    if (form.radius > 1e-3f * m_dabs.settings().radius)
        m_dabs.pile(anchor->sample, anchor->contact, form,
                    m_dabs.settings().fullTap ? m_dabs.overlap(usualSpacing) : 1);
}

class Line : public Method {
  public:
    explicit Line(Dabs& dabs) : m_dabs(dabs), m_space(makeSpace(dabs)) {}
    void add(const StrokeSample& sample, bool moved) override;
    void finish() override { m_space->finish(); }

  private:
    Dabs& m_dabs;
    std::unique_ptr<Method> m_space;
    std::optional<StrokeSample> m_first;
    std::optional<Entrance> m_start; ///< the first sample, where it meets the version that the stroke began on
};

void Line::add(const StrokeSample& sample, bool) {
    if (!m_first) {
        m_first = sample;
        m_start = entranceAt(m_dabs, sample);
        if (m_start)
            m_space = makeSpace(m_dabs, m_start->sample, m_start->contact);
        return;
    }
    m_dabs.restart();
    const std::optional<Entrance> in = m_start ? m_start : firstBetween(m_dabs, *m_first, sample);
    m_space = in ? makeSpace(m_dabs, in->sample, in->contact) : makeSpace(m_dabs);
    m_space->add(sample, true);
}

} // namespace

std::unique_ptr<Method> makeDots(Dabs& dabs) {
    return std::make_unique<Dots>(dabs);
}
std::unique_ptr<Method> makeAirbrush(Dabs& dabs) {
    return std::make_unique<Airbrush>(dabs);
}
std::unique_ptr<Method> makeAnchored(Dabs& dabs) {
    return std::make_unique<Anchored>(dabs);
}
std::unique_ptr<Method> makeLine(Dabs& dabs) {
    return std::make_unique<Line>(dabs);
}

std::unique_ptr<Method> makeMethod(Dabs& dabs, Motion motion) {
    if (motion == Motion::Drag)
        return makeDrag(dabs);
    if (motion == Motion::Turn)
        return makeTurn(dabs);
    switch (dabs.settings().method) {
    case StrokeMethod::Space:
        return makeSpace(dabs);
    case StrokeMethod::Dots:
        return makeDots(dabs);
    case StrokeMethod::Airbrush:
        return makeAirbrush(dabs);
    case StrokeMethod::Anchored:
        return makeAnchored(dabs);
    case StrokeMethod::Line:
        return makeLine(dabs);
    }
    return makeSpace(dabs);
}

} // namespace sculpt
