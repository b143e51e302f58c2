// Space: dabs evenly along the surface.
#include "core/sculpt/stroke/stroke_entrance.h"
#include "core/sculpt/stroke/stroke_methods.h"
#include "core/sculpt/stroke/stroke_way.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

namespace {

/// A dab lies this part of its distance too far at most: what is delivered in other pieces makes the same dabs.
constexpr float precision = 1e-4f;
constexpr int mostHalvings = 16;
/// The pointer goes at least this part of a dab's distance between two dabs, whatever the surface does: slopes that are
/// seen under more than 89 degrees have their dabs farther apart.
constexpr float leastTravel = 0.02f;
/// On the surface that the stroke began on a dab is at least its distance over this away from the last, and beside that
/// surface on the pointer's way. The front that dabs dig or raise is steep: by its length alone more dabs would make it
/// steeper, and those call for more again; an outline that they push out would be pushed with the pointer.
constexpr float mostOwnSlope = 1.25f;
/// Two places that are looked at are at least this part of a step apart.
constexpr float leastAhead = 0.1f;

/// A place on the way where a dab is due, with the contact that the search for it has found.
struct Due {
    float at = 0; ///< in steps
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
    float step() const { return m_dabs.settings().spacing * m_radius; }
    float gapTo(float place, const StrokeSample& sample, const Contact& at) const;
    std::optional<Due> search(float from, float below, float to, float gap, Due due) const;
    std::optional<Due> beforeTheEnd(float from, float out) const;
    bool lookAt(float place);
    void follow();
    void touch(const StrokeSample& sample, const Contact& at);
    void dab(const StrokeSample& sample, const Contact& at, const base::Vec3f& upwards);
    void fill();
    float gapAt(float place, Due& due) const;

    Dabs& m_dabs;
    std::optional<StrokeSample> m_previous;
    /// Where the last dab's own ray meets what the dab has left; where it meets nothing, what it touched.
    std::optional<Contact> m_last;
    std::optional<Contact> m_lastBefore; ///< where that ray met the version that the stroke began on
    float m_radius = 0;                  ///< of the last dab
    /// Since the last dab or the place that was looked at last; looked at on it is from m_from on, where the gap to the
    /// last dab is m_below (nearly none behind a dab, below 0 where there is no contact), and next at m_next.
    StrokeWay m_way;
    float m_from = 0, m_below = 0, m_next = 1;
    float m_since = 0; ///< from the last dab to where that way begins
    std::optional<Contact> m_first;
    float m_reach = 0; ///< of the dabs' contacts, from the first
    int m_made = 0;
    /// A first dab whose stamp follows the stroke waits for its direction.
    std::optional<StrokeSample> m_waiting;
};

/// Of a contact at `place` of the way from the last, in steps; no more than what was there before the stroke allows, or
/// the pointer's way beside that. Both only count for what is far enough.
float Space::gapTo(float place, const StrokeSample& sample, const Contact& at) const {
    const float step = this->step() * sample.stride, gap = distance(at.position, m_last->position) / step;
    if (gap < 1 || !m_dabs.touchesItsOwn())
        return gap;
    const auto before = m_lastBefore ? m_dabs.contactBefore(sample.ray) : std::nullopt;
    const float there = before ? distance(before->position, m_lastBefore->position) / step : m_since + place;
    return std::min(gap, mostOwnSlope * there);
}

/// Of a place on the way; where it is far enough, that place is due. A miss is never far enough.
float Space::gapAt(float place, Due& due) const {
    const StrokeSample sample = m_way.at(place);
    const auto c = m_dabs.contact(sample.ray);
    const float gap = c ? gapTo(place, sample, *c) : -1.0f;
    if (gap >= 1)
        due = {place, sample, *c};
    return gap;
}

/// The first place between `lo`, which is not far enough, and `hi`, which is and due, that is a step away.
/// Where the contact jumps (the pointer crosses an outline) the place behind the jump counts.
std::optional<Due> Space::search(float lo, float below, float hi, float gap, Due due) const {
    for (int k = 0; k < mostHalvings && gap > 1 + precision; ++k) {
        // Where a line through both ends would have it; half way where that has not helped, and at outlines.
        const float line = (1 - below) / (gap - below);
        const float part = k % 3 == 2 || below < 0 ? 0.5f : std::clamp(line + 0.5f * precision, 0.05f, 0.95f);
        const float middle = lo + part * (hi - lo), there = gapAt(middle, due);
        if (there >= 1)
            hi = middle, gap = there;
        else
            lo = middle, below = there;
    }
    return due;
}

/// The same where the model ends between `lo`, which is not far enough, and `out`, which misses: the last places before
/// that end may be.
std::optional<Due> Space::beforeTheEnd(float lo, float out) const {
    float below = m_below;
    for (int k = 0; k < mostHalvings; ++k) {
        Due due;
        const float middle = 0.5f * (lo + out), there = gapAt(middle, due);
        if (there >= 1)
            return search(lo, below, middle, there, due);
        if (there < 0)
            out = middle;
        else
            lo = middle, below = there;
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
    if (m_last) {
        m_way.add(sample);
        follow();
    }
    m_previous = sample;
}

/// Looks where the way is by then: at places that the way alone decides, not at those where samples happen to lie. What
/// is beyond the last of them waits for more of the way, or its end.
void Space::follow() {
    int probes = 0;
    for (; m_next <= m_way.length() && probes < mostProbes; ++probes)
        lookAt(m_next);
    if (probes == mostProbes) { // it sweeps far beyond the model
        m_since += m_way.length();
        m_way.leave(m_way.length());
        m_from = 0, m_below = -1, m_next = 1;
    }
}

/// Is a dab due on the way up to there? Makes it and goes on behind it, else behind `place`.
bool Space::lookAt(float place) {
    Due there;
    const float gap = gapAt(place, there);
    std::optional<Due> due;
    if (gap >= 1)
        due = search(m_from, m_below, place, gap, there);
    else if (gap < 0 && m_below >= 0)
        due = beforeTheEnd(m_from, place);
    if (due) {
        m_way.leave(due->at);
        touch(due->sample, due->contact);
        return true;
    }
    m_way.leave(place);
    m_since += place;
    m_from = 0, m_below = gap;
    m_next = std::max(1 - std::max(gap, 0.0f), leastAhead);
    return false;
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
    }
    if (m_waiting)
        m_last = at;
    m_way.begin(sample, m_last->distance, step());
    m_since = 0, m_from = leastTravel, m_below = 0, m_next = leastTravel + 1;
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
    while (m_last && m_from < m_way.length() && lookAt(m_way.length())) {
    }
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
