// Drag and Turn: what was touched first is held, and goes with the pointer or around the first contact.
#include "core/sculpt/stroke/stroke_entrance.h"
#include "core/sculpt/stroke/stroke_methods.h"

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
    base::Vec3f seen;    ///< of a drag: where the pointer was last
    base::Vec3f move;    ///< from `pointer` to there, still to be dragged
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
    /// Does the whole steps of the way to a sample and notes what is left.
    virtual void go(const StrokeSample& sample) = 0;
    virtual float waitingLength() const = 0; ///< the longest of all images
    /// The dab that does a share of what waits, and what is left after it.
    virtual Dab part(const Held& held, float share) const = 0;
    virtual void done(Held& held, float share) const = 0;
    template <class Fn>
    void forHeld(const Fn& fn) {
        for (std::size_t i = 0; i < m_held.size(); ++i)
            if (m_held[i])
                fn(*m_held[i], i);
    }
    /// Where image `i` of the pointer is: in space where it has a place there, else in the held plane; nothing where
    /// its ray runs beside that.
    std::optional<base::Vec3f> pointerIn(const Held& held, std::size_t i, const StrokeSample& sample) const;
    /// Does a share of what waits.
    void step(float share);

    Dabs& m_dabs;
    std::vector<std::optional<Held>> m_held;

  private:
    void hold(const StrokeSample& sample, const Contact& own);
    std::vector<Dab> parts(float share) const;

    std::optional<StrokeSample> m_before; ///< that met nothing
};

void Holding::add(const StrokeSample& sample, bool) {
    if (m_held.empty()) {
        const auto in = entranceBetween(m_dabs, m_before, sample);
        m_before = sample;
        if (!in)
            return;
        hold(in->sample, in->contact);
        if (in->sample == sample)
            return;
    }
    go(sample);
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

void Holding::hold(const StrokeSample& sample, const Contact& own) {
    m_dabs.begin(own);
    const Dabs::Contacts contacts = m_dabs.contactsOf(sample.ray, own);
    const std::vector<float> share = Dabs::shares(contacts, m_dabs.settings().radius);
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (!contacts[i]) {
            m_held.push_back({});
            continue;
        }
        const Dab dab = m_dabs.dabOf(*contacts[i], i, sample.ray.direction, {m_dabs.settings().radius, share[i], {}});
        m_held.push_back(Held{dab, dab.view, contacts[i]->position, contacts[i]->position, {}, 0});
    }
}

std::optional<base::Vec3f> Holding::pointerIn(const Held& held, std::size_t i, const StrokeSample& sample) const {
    const base::Rayf ray = m_dabs.images()[i].ray(sample.ray);
    if (sample.reach > 0)
        return ray.at(sample.reach);
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
    Dab part(const Held& held, float share) const override;
    void done(Held& held, float share) const override;
};

/// The part u of the way from `from` to `to` where it leaves the ball of this radius around the origin; more than 1
/// where it ends inside.
double leavesAt(const base::Vec3d& from, const base::Vec3d& to, double radius) {
    const base::Vec3d way = to - from;
    const double a = lengthSq(way), b = dot(from, way), c = lengthSq(from) - radius * radius;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    if (b < 0)
        return (root - b) / a;
    return b + root > 0 ? -c / (b + root) : 2.0; // the same without cancellation; no way at all
}

/// Each step ends on the way of the pointer, where that is first a step away: straight to the sample it would cut
/// corners, the more the fewer samples come.
void Drag::go(const StrokeSample& sample) {
    std::vector<base::Vec3f> to(m_held.size());
    float far = 0;
    forHeld([&](Held& h, std::size_t i) {
        to[i] = pointerIn(h, i, sample).value_or(h.seen);
        far = std::max(far, distance(to[i], h.seen) + length(h.move));
    });
    const float longest = std::min(stepOfDrag, m_dabs.settings().spacing) * m_dabs.settings().radius;
    const double each = double(std::max(longest, far / float(mostProbes)));
    const auto placeOf = [&](const Held& h, std::size_t i, double u) {
        return base::cast<double>(h.seen) + base::cast<double>(to[i] - h.seen) * u;
    };
    for (int left = mostProbes; left > 0; --left) {
        double u = 2;
        forHeld([&](Held& h, std::size_t i) {
            const base::Vec3d done = base::cast<double>(h.pointer);
            u = std::min(u, leavesAt(placeOf(h, i, 0) - done, placeOf(h, i, 1) - done, each));
        });
        if (!(u <= 1 + 1e-6)) // up to rounding
            break;
        u = std::min(u, 1.0);
        forHeld([&](Held& h, std::size_t i) { h.move = base::cast<float>(placeOf(h, i, u)) - h.pointer; });
        step(1);
    }
    forHeld([&](Held& h, std::size_t i) { h.seen = to[i], h.move = to[i] - h.pointer; });
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
    const float far = waitingLength(), each = std::max(stepOfTurn, far / float(mostProbes));
    for (int left = static_cast<int>(far / each); left > 0; --left)
        step(std::min(1.0f, each / waitingLength()));
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
