// Drag and Turn: what was touched first is held, and goes with the pointer or around the first contact.
#include "core/sculpt/stroke_methods.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

namespace {

/// Steps of a drag are at most this long, in radii, and those of a turn in radians: grab's iteration contracts there.
constexpr float stepOfDrag = 0.1f, stepOfTurn = 0.1f;
/// Part of the radius around the contact where a pointer has no direction to turn by.
constexpr float deaf = 0.02f;

/// What is held, one per image.
struct Held {
    Dab dab;
    base::Vec3f plane;   ///< unit normal of the plane that faces the viewer
    base::Vec3f pointer; ///< place in it: of a drag, as far as steps have gone; of a turn, the last
    base::Vec3f move;    ///< from there to the pointer, still to be dragged
    float angle = 0;     ///< still to be turned
};

/// The first contact of every image, held from now on. Whole steps are done as soon as the pointer is so far away; what
/// is left waits, and is only shown: however a path is delivered, the same steps are done.
class Holding : public Method {
  public:
    explicit Holding(Dabs& dabs) : m_dabs(dabs) {}
    void add(const StrokeSample& sample, bool) override;
    bool waits() const override { return waitingLength() > 0; }
    std::vector<Dab> waiting() const override { return waits() ? parts(1) : std::vector<Dab>{}; }
    void finish() override {
        if (waits())
            step(1);
    }

  protected:
    /// Adds to what is still to be done.
    virtual void go(const StrokeSample& sample) = 0;
    virtual float waitingLength() const = 0; ///< the longest of all images
    virtual float longestStep() const = 0;
    /// The dab that does a share of what waits, and what is left after it.
    virtual Dab part(const Held& held, float share) const = 0;
    virtual void done(Held& held, float share) const = 0;
    template <class Fn>
    void forHeld(const Fn& fn) {
        for (std::size_t i = 0; i < m_held.size(); ++i)
            if (m_held[i])
                fn(*m_held[i], i);
    }
    /// Where image `i` of the pointer is in the held plane; nothing where its ray runs beside it.
    std::optional<base::Vec3f> pointerIn(const Held& held, std::size_t i, const StrokeSample& sample) const;

    Dabs& m_dabs;
    std::vector<std::optional<Held>> m_held;

  private:
    void hold(const StrokeSample& sample);
    std::vector<Dab> parts(float share) const;
    void step(float share);
};

void Holding::add(const StrokeSample& sample, bool) {
    if (m_held.empty())
        return hold(sample);
    go(sample);
    const float far = waitingLength(), each = std::max(longestStep(), far / float(mostProbes));
    for (int left = static_cast<int>(far / each); left > 0; --left)
        step(std::min(1.0f, each / waitingLength()));
}

std::vector<Dab> Holding::parts(float share) const {
    std::vector<Dab> out;
    for (const auto& h : m_held)
        if (h)
            out.push_back(part(*h, share));
    return out;
}

void Holding::step(float share) {
    m_dabs.apply(parts(share));
    forHeld([&](Held& h, std::size_t) { done(h, share); });
}

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
        m_held.push_back(Held{dab, dab.view, contacts[i]->position, {}, 0});
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
    float waitingLength() const override;
    float longestStep() const override {
        return std::min(stepOfDrag, m_dabs.settings().spacing) * m_dabs.settings().radius;
    }
    Dab part(const Held& held, float share) const override;
    void done(Held& held, float share) const override;
};

void Drag::go(const StrokeSample& sample) {
    forHeld([&](Held& h, std::size_t i) {
        if (const auto to = pointerIn(h, i, sample))
            h.move = *to - h.pointer;
    });
}

float Drag::waitingLength() const {
    float longest = 0;
    for (const auto& h : m_held)
        longest = std::max(longest, h ? length(h->move) : 0.0f);
    return longest;
}

Dab Drag::part(const Held& held, float share) const {
    Dab out = held.dab;
    out.move = held.move * share;
    return out;
}

void Drag::done(Held& held, float share) const {
    const base::Vec3f step = held.move * share;
    held.pointer += step, held.move = held.move - step;
    held.dab.centre += step * m_dabs.settings().strength; // the ball stays with what it holds
}

class Turn : public Holding {
  public:
    using Holding::Holding;

  private:
    void go(const StrokeSample& sample) override;
    float waitingLength() const override;
    float longestStep() const override { return stepOfTurn; }
    Dab part(const Held& held, float share) const override;
    void done(Held& held, float share) const override { held.angle -= held.angle * share; }
};

void Turn::go(const StrokeSample& sample) {
    forHeld([&](Held& h, std::size_t i) {
        const auto to = pointerIn(h, i, sample);
        if (!to || distance(*to, h.dab.centre) < deaf * h.dab.radius)
            return;
        const base::Vec3f a = h.pointer - h.dab.centre, b = *to - h.dab.centre;
        if (length(a) >= deaf * h.dab.radius)
            h.angle += std::atan2(-dot(cross(a, b), h.plane), dot(a, b));
        h.pointer = *to;
    });
}

float Turn::waitingLength() const {
    float widest = 0;
    for (const auto& h : m_held)
        widest = std::max(widest, h ? std::abs(h->angle) : 0.0f);
    return widest;
}

Dab Turn::part(const Held& held, float share) const {
    Dab out = held.dab;
    out.angle = held.angle * share;
    return out;
}

} // namespace

std::unique_ptr<Method> makeDrag(Dabs& dabs) {
    return std::make_unique<Drag>(dabs);
}
std::unique_ptr<Method> makeTurn(Dabs& dabs) {
    return std::make_unique<Turn>(dabs);
}

} // namespace sculpt
