// Space: dabs evenly along the surface.
#include "core/sculpt/stroke_entrance.h"
#include "core/sculpt/stroke_methods.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

namespace {

/// A dab lies this part of its distance too far at most: what is delivered in other pieces makes the same dabs.
constexpr float precision = 5e-4f;
constexpr int mostHalvings = 16;
/// The pointer goes at least this part of a dab's distance between two dabs, whatever the surface does: slopes that are
/// seen under more than 89 degrees have their dabs farther apart.
constexpr float leastTravel = 0.02f;
/// On the surface that the stroke began on a dab is at least its distance over this away from the last. The front that
/// dabs dig or raise is steep: by its length alone more dabs would make it steeper, and those call for more again.
constexpr float mostOwnSlope = 1.25f;

/// A place between two samples where a dab is due, with the contact that the search for it has found.
struct Due {
    float u = 0; ///< part of the way
    StrokeSample sample;
    Contact contact;
};

class Space : public Method {
  public:
    explicit Space(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool moved) override;
    void finish() override;
    void begin(const StrokeSample& sample, const Contact& at);

  private:
    float step(const StrokeSample& to) const { return m_dabs.settings().spacing * m_radius * to.stride; }
    float sweep(const StrokeSample& to) const {
        return distance(to.ray.at(m_last->distance), m_previous->ray.at(m_last->distance));
    }
    float gapTo(const StrokeSample& sample, const Contact& at, float step) const;
    std::optional<Due> advance(const StrokeSample& to, float from, int& probes) const;
    void follow(const StrokeSample& to);
    void touch(const StrokeSample& sample, const Contact& at);
    void dab(const StrokeSample& sample, const Contact& at, const base::Vec3f& upwards);
    void fill();

    Dabs& m_dabs;
    std::optional<StrokeSample> m_previous;
    /// Where the last dab's own ray meets what the dab has left; where it meets nothing, what it touched.
    std::optional<Contact> m_last;
    std::optional<Contact> m_lastBefore; ///< where that ray met the version that the stroke began on
    float m_radius = 0;                  ///< of the last dab
    float m_travelled = 0;               ///< by the pointer since then, up to m_previous
    std::optional<Contact> m_first;
    float m_reach = 0; ///< of the dabs' contacts, from the first
    int m_made = 0;
    /// A first dab whose stamp follows the stroke waits for its direction.
    std::optional<StrokeSample> m_waiting;
};

/// Of a contact from the last; no more than that on the first version allows, which only counts for what is far enough.
float Space::gapTo(const StrokeSample& sample, const Contact& at, float step) const {
    const float gap = distance(at.position, m_last->position);
    if (gap < step || !m_lastBefore)
        return gap;
    const auto before = m_dabs.contactBefore(sample.ray);
    return before ? std::min(gap, mostOwnSlope * distance(before->position, m_lastBefore->position)) : gap;
}

/// How far between the last two samples, at least `from`, the surface is next a dab's distance from the last contact.
/// Where the contact jumps (the pointer crosses an outline) the place behind the jump counts.
std::optional<Due> Space::advance(const StrokeSample& to, float from, int& probes) const {
    const float step = this->step(to), sweep = this->sweep(to);
    if (sweep > 0)
        from += std::max(0.0f, leastTravel * step - m_travelled) / sweep;
    Due due;
    const auto gapAt = [&](float u) { // where it is far enough, that place is due
        const StrokeSample sample = between(*m_previous, to, u);
        const auto c = m_dabs.contact(sample.ray);
        const float gap = c ? gapTo(sample, *c, step) : -1.0f; // a miss is never far enough
        if (gap >= step)
            due = {u, sample, *c};
        return gap;
    };
    float below = 0; // the gap at lo; where the search starts it is nearly none
    for (float lo = from, ahead = step; lo < 1 && probes < mostProbes; ++probes) {
        float hi = sweep > 0 ? std::min(1.0f, lo + std::max(ahead / sweep, 1e-4f)) : 1.0f;
        float gap = gapAt(hi);
        if (gap < step) {
            ahead = std::max(step - std::max(gap, 0.0f), 0.1f * step);
            lo = hi, below = gap;
            continue;
        }
        for (int k = 0; k < mostHalvings && gap > (1 + precision) * step; ++k) {
            // Where a line through both ends would have it; half way where that has not helped, and at outlines.
            const float line = (step - below) / (gap - below);
            const float part = k % 3 == 2 || below < 0 ? 0.5f : std::clamp(line + 0.5f * precision, 0.05f, 0.95f);
            const float middle = lo + part * (hi - lo), there = gapAt(middle);
            if (there >= step)
                hi = middle, gap = there;
            else
                lo = middle, below = there;
        }
        return due;
    }
    return {};
}

void Space::begin(const StrokeSample& sample, const Contact& at) {
    touch(sample, at);
    m_previous = sample;
}

void Space::add(const StrokeSample& sample, bool) {
    if (!m_last) {
        if (const auto in = entranceBetween(m_dabs, m_previous, sample))
            begin(in->sample, in->contact);
    }
    if (m_last)
        follow(sample);
    m_previous = sample;
}

void Space::follow(const StrokeSample& to) {
    int probes = 0;
    float u = 0;
    while (u < 1) {
        const std::optional<Due> due = advance(to, u, probes);
        if (!due)
            break;
        touch(due->sample, due->contact);
        u = due->u;
        m_travelled = 0;
    }
    m_travelled += (1 - u) * sweep(to);
}

void Space::touch(const StrokeSample& sample, const Contact& at) {
    const bool follows = m_dabs.settings().stampFollows && !m_dabs.settings().stamp.empty();
    if (follows && !m_last) {
        m_dabs.begin(at);
        m_radius = m_dabs.form(sample).radius;
        m_waiting = sample;
    } else {
        const bool waited = m_waiting.has_value();
        if (waited)
            dab(*m_waiting, *m_last, at.position - m_last->position);
        m_waiting.reset();
        if (const auto now = waited ? m_dabs.contact(sample.ray) : at) // on what the first dab has left
            dab(sample, *now, {});
        // A dab that moves the surface farther than one step along the ray would else call for the next at once.
        m_last = m_dabs.contact(sample.ray).value_or(at);
        m_lastBefore = m_dabs.contactBefore(sample.ray);
        return;
    }
    m_last = at;
}

void Space::dab(const StrokeSample& sample, const Contact& at, const base::Vec3f& upwards) {
    Dabs::Form form = m_dabs.form(sample);
    m_radius = form.radius;
    form.upwards = upwards;
    m_dabs.dabAt(sample, at, form);
    if (!m_first)
        m_first = at;
    m_reach = std::max(m_reach, distance(m_first->position, at.position));
    ++m_made;
}

/// What a tap lacks of the dabs that a stroke would have laid over its place. A hand that trembles is still a tap: what
/// is added fades out over a quarter of the radius.
void Space::fill() {
    if (!m_dabs.settings().fullTap || !m_first || !m_previous)
        return;
    constexpr float tremble = 0.25f;
    const double still = std::max(0.0, 1 - double(m_reach) / double(tremble * m_radius));
    const double lacking = (m_dabs.overlap(m_dabs.settings().spacing) - m_made) * still;
    if (!(lacking > 0))
        return;
    if (const auto touched = m_dabs.contact(m_previous->ray))
        m_dabs.pile(*m_previous, *touched, m_dabs.form(*m_previous), lacking);
    m_made += static_cast<int>(std::ceil(lacking));
}

void Space::finish() {
    if (m_waiting)
        dab(*m_waiting, *m_last, {});
    m_waiting.reset();
    fill();
}

} // namespace

std::unique_ptr<Method> makeSpace(Dabs& dabs) {
    return std::make_unique<Space>(dabs);
}

std::unique_ptr<Method> makeSpace(Dabs& dabs, const StrokeSample& first, const Contact& at) {
    auto out = std::make_unique<Space>(dabs);
    out->begin(first, at);
    return out;
}

} // namespace sculpt
