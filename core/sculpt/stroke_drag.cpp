// Drag and Turn: what was touched first is held, and goes with the pointer or around the first contact.
#include "core/sculpt/stroke_methods.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

namespace {

/// Steps of a drag are at most this long, in radii, and those of a turn in radians: grab's iteration contracts there.
constexpr float longestStep = 0.1f;
/// Part of the radius around the contact where a pointer has no direction to turn by.
constexpr float deaf = 0.02f;

/// What is held, one per image.
struct Held {
    Dab dab;
    base::Vec3f plane;   ///< unit normal of the plane that faces the viewer
    base::Vec3f pointer; ///< place in it
};

/// The first contact of every image, held from now on. What happens at later samples differs.
class Holding : public Method {
  public:
    explicit Holding(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool) override {
        if (m_held.empty())
            hold(sample);
        else
            go(sample);
    }

  protected:
    virtual void go(const StrokeSample& sample) = 0;
    /// Where image `i` of the pointer is in the held plane; nothing where its ray runs beside it.
    std::optional<base::Vec3f> pointerIn(const Held& held, std::size_t i, const StrokeSample& sample) const;

    Dabs& m_dabs;
    std::vector<std::optional<Held>> m_held;

  private:
    void hold(const StrokeSample& sample);
};

void Holding::hold(const StrokeSample& sample) {
    const std::optional<Contact> own = m_dabs.contact(sample.ray);
    if (!own)
        return;
    m_dabs.begin(*own);
    const Dabs::Contacts contacts = m_dabs.contactsOf(sample.ray, *own);
    const std::vector<float> share = Dabs::shares(contacts, m_dabs.settings().radius);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!contacts[i]) {
            m_held.push_back({});
            continue;
        }
        const Dab dab = m_dabs.dabOf(*contacts[i], i, sample.ray.direction, {m_dabs.settings().radius, share[i], {}});
        m_held.push_back(Held{dab, dab.view, contacts[i]->position});
    }
}

std::optional<base::Vec3f> Holding::pointerIn(const Held& held, std::size_t i, const StrokeSample& sample) const {
    const base::Rayf ray = m_dabs.images()[i].ray(sample.ray);
    const float facing = dot(ray.direction, held.plane), t = dot(held.pointer - ray.origin, held.plane) / facing;
    if (!(facing > 0.05f) || !(t > 0) || !std::isfinite(t))
        return {};
    return ray.at(t);
}

class Drag : public Holding {
  public:
    using Holding::Holding;

  private:
    void go(const StrokeSample& sample) override;
    float pull(const StrokeSample& sample);
};

/// Takes every held place's `move` to the pointer and returns the longest.
float Drag::pull(const StrokeSample& sample) {
    float longest = 0;
    for (std::size_t i = 0; i < m_held.size(); ++i) {
        if (!m_held[i])
            continue;
        Held& h = *m_held[i];
        h.dab.move = {};
        if (const auto to = pointerIn(h, i, sample)) {
            h.dab.move = *to - h.pointer;
            h.pointer = *to;
            longest = std::max(longest, length(h.dab.move));
        }
    }
    return longest;
}

void Drag::go(const StrokeSample& sample) {
    const float longest = pull(sample);
    const float step = std::min(longestStep, m_dabs.settings().spacing) * m_dabs.settings().radius;
    const int steps = static_cast<int>(std::min(std::ceil(longest / step), float(mostProbes)));
    for (auto& h : m_held)
        if (h)
            h->dab.move = h->dab.move / float(std::max(1, steps));
    for (int k = 0; k < steps; ++k) {
        std::vector<Dab> all;
        for (auto& h : m_held)
            if (h) {
                all.push_back(h->dab);
                h->dab.centre += h->dab.move * m_dabs.settings().strength; // the ball stays with what it holds
            }
        m_dabs.apply(all);
    }
}

class Turn : public Holding {
  public:
    using Holding::Holding;

  private:
    void go(const StrokeSample& sample) override;
};

void Turn::go(const StrokeSample& sample) {
    float widest = 0;
    for (std::size_t i = 0; i < m_held.size(); ++i) {
        if (!m_held[i])
            continue;
        Held& h = *m_held[i];
        h.dab.angle = 0;
        const auto to = pointerIn(h, i, sample);
        if (!to || distance(*to, h.dab.centre) < deaf * h.dab.radius)
            continue;
        const base::Vec3f a = h.pointer - h.dab.centre, b = *to - h.dab.centre;
        if (length(a) >= deaf * h.dab.radius)
            h.dab.angle = std::atan2(-dot(cross(a, b), h.plane), dot(a, b));
        h.pointer = *to;
        widest = std::max(widest, std::abs(h.dab.angle));
    }
    const int steps = static_cast<int>(std::ceil(widest / longestStep));
    std::vector<Dab> all;
    for (auto& h : m_held)
        if (h) {
            h->dab.angle /= float(std::max(1, steps));
            all.push_back(h->dab);
        }
    for (int k = 0; k < steps; ++k)
        m_dabs.apply(all);
}

} // namespace

std::unique_ptr<Method> makeDrag(Dabs& dabs) {
    return std::make_unique<Drag>(dabs);
}
std::unique_ptr<Method> makeTurn(Dabs& dabs) {
    return std::make_unique<Turn>(dabs);
}

} // namespace sculpt
