#include "core/sculpt/stroke.h"

#include "core/base/error.h"
#include "core/sculpt/contact.h"
#include "core/sculpt/mirror.h"
#include "core/sculpt/sampling.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace sculpt {

namespace {

/// Part of the radius whose surfels make the area normal, as Blender's "normal radius".
constexpr float areaShare = 0.5f;
/// Steps of a drag are at most this long, in radii: grab's iteration contracts there.
constexpr float longestStep = 0.1f;
/// Probes between two samples: a bound for rays that sweep far beyond the model.
constexpr int mostProbes = 4096;

using Contacts = std::vector<std::optional<Contact>>;

StrokeSample checked(StrokeSample sample) {
    const float length = base::length(sample.ray.direction);
    if (!isFinite(sample.ray.origin) || !(length > 0) || !std::isfinite(length))
        throw base::Error("a sample's ray is not finite or has no direction", "stroke",
                          "give origin and direction of each sample");
    if (!(sample.pressure >= 0 && sample.pressure <= 1))
        throw base::Error("a sample's pressure is not between 0 and 1", "stroke");
    sample.ray.direction = sample.ray.direction / length;
    return sample;
}

StrokeSample between(const StrokeSample& a, const StrokeSample& b, float u) {
    StrokeSample out;
    out.ray.origin = a.ray.origin + (b.ray.origin - a.ray.origin) * u;
    out.ray.direction = normalized(a.ray.direction + (b.ray.direction - a.ray.direction) * u, b.ray.direction);
    out.pressure = a.pressure + (b.pressure - a.pressure) * u;
    out.seconds = a.seconds + (b.seconds - a.seconds) * u;
    return out;
}

/// Shares of the strength where mirrored brushes overlap.
std::vector<float> feather(const Contacts& contacts, float radius) {
    std::vector<float> share(contacts.size(), 0.0f);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!contacts[i])
            continue;
        float overlap = 0;
        for (const auto& other : contacts)
            if (other)
                overlap += std::max(0.0f, 1 - distance(contacts[i]->position, other->position) / (2 * radius));
        share[i] = 1 / overlap;
    }
    return share;
}

class Stopwatch {
  public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

  private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// What a drag carries, one per mirror image.
struct Held {
    Dab dab;
    base::Vec3f plane;   ///< unit normal of the plane that faces the viewer
    base::Vec3f pointer; ///< place in it
};

} // namespace

struct Stroke::State {
    surface::Surface surface;
    StrokeSettings settings;
    const ToolRow& row;
    std::vector<Mirror> images;
    Dab pattern; ///< what all dabs have in common
    Sampling sampling;
    int dabs = 0;
    std::vector<double> seconds;

    std::optional<StrokeSample> previous;
    std::optional<Contact> last; ///< of the last dab's own ray
    std::vector<std::optional<Held>> held;

    State(surface::Surface start, StrokeSettings s, const base::Vec3d& origin);
    bool along(const StrokeSample& sample);
    bool drag(const StrokeSample& sample);
    void finish();

  private:
    std::optional<float> advance(const StrokeSample& to, float from, int& probes) const;
    void dabAt(const StrokeSample& sample, const Contact& first);
    Contacts contactsOf(const base::Rayf& ray) const;
    Dab dabOf(const Contact& contact, const base::Vec3f& view, float strength) const;
    void hold(const StrokeSample& sample);
    float pull(const StrokeSample& sample);
    void apply(const Dab& dab);
    void resampleIfDue();
};

Stroke::State::State(surface::Surface start, StrokeSettings s, const base::Vec3d& origin)
    : surface(std::move(start)), settings(std::move(s)), row(tool(settings.tool)),
      images(mirrors(settings.symmetry, origin)) {
    check(settings);
    pattern.radius = settings.radius;
    pattern.falloff = settings.falloff;
    pattern.strength = settings.invert ? -settings.strength : settings.strength;
    if (row.motion == Motion::Along)
        pattern.strength *= std::min(1.0f, settings.spacing / usualSpacing);
    for (const ToolParameter& parameter : row.parameters)
        pattern.parameters[parameter.id] = parameter.fallback;
    for (const auto& [id, value] : settings.parameters)
        pattern.parameters[id] = value;
}

Contacts Stroke::State::contactsOf(const base::Rayf& ray) const {
    Contacts out;
    for (const Mirror& image : images)
        out.push_back(contact(surface, image.ray(ray)));
    return out;
}

Dab Stroke::State::dabOf(const Contact& at, const base::Vec3f& view, float strength) const {
    Dab dab = pattern;
    const Area area = areaAround(surface, at, areaShare * settings.radius);
    dab.centre = at.position;
    dab.normal = at.normal;
    dab.areaNormal = area.normal;
    dab.areaCentre = area.centre;
    dab.view = view;
    dab.strength *= strength;
    return dab;
}

void Stroke::State::apply(const Dab& dab) {
    const tree::Edit edit = row.apply(surface, dab);
    if (edit.empty())
        return;
    if (settings.resample)
        sampling.note(surface.tree(), edit, dab);
    surface = {surface.tree().apply(edit), surface.definition()};
}

void Stroke::State::resampleIfDue() {
    if (settings.resample && sampling.due())
        surface = sampling.resample(surface);
}

void Stroke::State::finish() {
    if (settings.resample && sampling.pending())
        surface = sampling.resample(surface);
}

/// One dab with its mirror images. Their contacts and areas are found before any of them is applied, so that a
/// symmetric model keeps symmetric contacts.
void Stroke::State::dabAt(const StrokeSample& sample, const Contact& first) {
    const Stopwatch watch;
    if (!sampling.started())
        sampling.start(surface, first.position);
    const Contacts contacts = contactsOf(sample.ray);
    const std::vector<float> share = feather(contacts, settings.radius);
    std::vector<Dab> all;
    for (std::size_t i = 0; i < images.size(); ++i)
        if (contacts[i])
            all.push_back(dabOf(*contacts[i], images[i].direction(sample.ray.direction), sample.pressure * share[i]));
    for (const Dab& dab : all)
        apply(dab);
    resampleIfDue();
    last = first;
    ++dabs;
    seconds.push_back(watch.seconds());
}

/// How far between the last two samples, at least `from`, the surface is next a dab's distance from the last contact.
/// Where the contact jumps (the pointer crosses an outline) the place behind the jump counts.
std::optional<float> Stroke::State::advance(const StrokeSample& to, float from, int& probes) const {
    const float step = settings.spacing * settings.radius;
    const float sweep = distance(to.ray.at(last->distance), previous->ray.at(last->distance));
    const auto gapAt = [&](float u) {
        const auto c = contact(surface, between(*previous, to, u).ray);
        return c ? distance(c->position, last->position) : -1.0f; // a miss is never far enough
    };
    for (float lo = from, ahead = step; lo < 1 && probes < mostProbes; ++probes) {
        float hi = sweep > 0 ? std::min(1.0f, lo + std::max(ahead / sweep, 1e-4f)) : 1.0f;
        float gap = gapAt(hi);
        if (gap < step) {
            ahead = std::max(step - std::max(gap, 0.0f), 0.1f * step);
            lo = hi;
            continue;
        }
        for (int k = 0; k < 10 && gap > 1.02f * step; ++k) {
            const float middle = 0.5f * (lo + hi), there = gapAt(middle);
            if (there >= step)
                hi = middle, gap = there;
            else
                lo = middle;
        }
        return hi;
    }
    return {};
}

bool Stroke::State::along(const StrokeSample& sample) {
    const int before = dabs;
    if (!last) {
        if (const auto first = contact(surface, sample.ray))
            dabAt(sample, *first);
    } else {
        int probes = 0;
        for (std::optional<float> u = 0.0f; (u = advance(sample, *u, probes));) {
            const StrokeSample at = between(*previous, sample, *u);
            const auto touched = contact(surface, at.ray);
            if (touched)
                dabAt(at, *touched);
            if (*u >= 1)
                break;
        }
    }
    previous = sample;
    return dabs > before;
}

/// The first contact of every image, held from now on.
void Stroke::State::hold(const StrokeSample& sample) {
    const Contacts contacts = contactsOf(sample.ray);
    if (!contacts.front())
        return;
    sampling.start(surface, contacts.front()->position);
    const std::vector<float> share = feather(contacts, settings.radius);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const base::Vec3f view = images[i].direction(sample.ray.direction);
        if (contacts[i])
            held.push_back(Held{dabOf(*contacts[i], view, share[i]), view, contacts[i]->position});
        else
            held.push_back({});
    }
}

/// Takes every held place's `move` to the pointer and returns the longest; images whose ray runs beside their plane
/// stay.
float Stroke::State::pull(const StrokeSample& sample) {
    float longest = 0;
    for (std::size_t i = 0; i < images.size(); ++i) {
        if (!held[i])
            continue;
        Held& h = *held[i];
        const base::Rayf ray = images[i].ray(sample.ray);
        const float facing = dot(ray.direction, h.plane), t = dot(h.pointer - ray.origin, h.plane) / facing;
        h.dab.move = {};
        if (!(facing > 0.05f) || !(t > 0) || !std::isfinite(t))
            continue;
        h.dab.move = ray.at(t) - h.pointer;
        h.pointer = ray.at(t);
        longest = std::max(longest, length(h.dab.move));
    }
    return longest;
}

bool Stroke::State::drag(const StrokeSample& sample) {
    if (held.empty()) {
        hold(sample);
        return false;
    }
    const float longest = pull(sample);
    const float step = std::min(longestStep, settings.spacing) * settings.radius;
    const int steps = static_cast<int>(std::min(std::ceil(longest / step), float(mostProbes)));
    for (auto& h : held)
        if (h)
            h->dab.move = h->dab.move / float(std::max(1, steps));
    for (int k = 0; k < steps; ++k) {
        const Stopwatch watch;
        for (auto& h : held) {
            if (!h)
                continue;
            apply(h->dab);
            h->dab.centre += h->dab.move * settings.strength; // the ball stays with what it holds
        }
        resampleIfDue();
        ++dabs;
        seconds.push_back(watch.seconds());
    }
    return steps > 0;
}

Stroke::Stroke(surface::Surface start, StrokeSettings settings, base::Vec3d origin)
    : m_state(std::make_unique<State>(std::move(start), std::move(settings), origin)) {}
Stroke::~Stroke() = default;
Stroke::Stroke(Stroke&&) noexcept = default;
Stroke& Stroke::operator=(Stroke&&) noexcept = default;

bool Stroke::add(const StrokeSample& sample) {
    const StrokeSample unit = checked(sample);
    return m_state->row.motion == Motion::Drag ? m_state->drag(unit) : m_state->along(unit);
}
void Stroke::finish() {
    m_state->finish();
}

const surface::Surface& Stroke::surface() const {
    return m_state->surface;
}
int Stroke::dabs() const {
    return m_state->dabs;
}
std::span<const double> Stroke::dabSeconds() const {
    return m_state->seconds;
}

} // namespace sculpt
