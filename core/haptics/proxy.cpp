#include "core/haptics/proxy.h"

#include "core/surface/projection/foot_step.h"

#include <algorithm>

namespace haptics {

using base::Vec3d, surface::Surface;

namespace {

constexpr double longestStep = 0.25; ///< of h, in contact
constexpr double done = 1e-6;        ///< of h: a step that is not worth while
constexpr double mostShift = 8;      ///< out of a corner, in depths: one of 14 degrees
constexpr double released = 0.05;    ///< of h: feet are kept in mind so far when the tool leaves them

/// Closed and oriented: what is behind the surface is inside.
bool hasInside(const Surface& surface) {
    return surface.tree().layout()->oriented && !std::isfinite(surface.definition().boundaryLimit);
}

/// Is the surface met from behind on the way from x to a foot? Of solids that is so inside alone, wherever the foot is.
bool seesBacks(const Surface& surface, const Vec3d& x, const Foot& foot) {
    const auto met = firstMet(surface, x, foot.position + (foot.position - x) * 0.01, {});
    return met && met->side < 0;
}

} // namespace

/// What the tool at x does to a proxy that touches: the way that is open to it, and what the contacts take up. The two
/// are at right angles.
struct Proxy::Pull {
    Vec3d along;    ///< towards the nearest place that the contacts allow
    Vec3d reaction; ///< from where the tool is to that place
    int contacts = 0;
    const Foot* only = nullptr; ///< the contact where there is one
};

Proxy::Pull Proxy::pullOf(const Vec3d& x) const {
    std::array<HalfSpace, Contacts::most> spaces;
    Pull out;
    for (const Foot& foot : m_contacts.feet())
        if (const double gap = gapOf(foot, m_position, m_tool.radius); gap <= touching * foot.unit) {
            // where the proxy has got to is allowed, even if no room is there: planes that nearly face each other have
            // a place in common far away
            spaces[static_cast<std::size_t>(out.contacts++)] = {foot.normal, std::min(0.0, -gap)};
            out.only = &foot;
        }
    const Vec3d pull = x - m_position;
    // what has no place in common leaves none to go to
    out.along = nearestIn({spaces.data(), static_cast<std::size_t>(out.contacts)}, pull).value_or(Vec3d{});
    out.reaction = out.along - pull;
    if (out.contacts != 1)
        out.only = nullptr;
    return out;
}

double Proxy::leastUnit() const {
    double out = std::numeric_limits<double>::infinity();
    for (const Foot& foot : m_contacts.feet())
        out = std::min(out, foot.unit);
    return out;
}

/// Where a step begins, where the tool is that it is for, and whether it is the last try.
struct Proxy::Way {
    Vec3d from, tool;
    bool smallest;
};

/// Where to go next, as far as the tangent planes of the contacts can tell (haptics/README 2.3, 2.4).
Vec3d Proxy::stepTo(const Vec3d& x) const {
    const Pull pull = pullOf(x);
    Vec3d step = pull.along;
    const double depth = length(pull.reaction);
    if (depth > 0) {
        const double most = m_tool.friction * depth, tangential = length(step);
        if (tangential <= most)
            return {};
        step *= 1 - most / tangential;
        if (pull.only) {
            surface::TangentMatrix<double> matrix(pull.only->normal);
            matrix.add(pull.only->bendAt(m_tool.radius), -depth);
            const double off = dot(step, pull.only->normal);
            step = matrix.solve(step, 0.5) + pull.only->normal * off;
        }
    }
    double most = std::numeric_limits<double>::infinity();
    if (depth > 0)
        most = longestStep * leastUnit();
    else if (m_tool.radius >
             longestStep * m_surroundings.unit()) // a smaller one is to the ray of its centre like a point
        most = std::max({longestStep * m_surroundings.unit(), 0.5 * m_tool.radius, m_surroundings.room()});
    const double size = length(step);
    double part = size > most ? most / size : 1;
    for (const Foot& foot : m_contacts.feet()) { // those that it does not touch yet
        const double gap = gapOf(foot, m_position, m_tool.radius), nearer = -dot(step, foot.normal);
        if (gap > touching * foot.unit && nearer > gap)
            part = std::min(part, gap / nearer);
    }
    return step * part;
}

/// One flat sheet and a short step: what else there is cannot be crossed without the foot telling (haptics/README 2.2).
bool Proxy::crossesFreely(const Vec3d& step) const {
    constexpr double flat = 0.95, brief = 0.1; // agreement; of h
    const auto feet = m_contacts.feet();
    return feet.size() == 1 && feet[0].agreement >= flat && length(step) <= brief * feet[0].unit;
}

/// Follows the feet to where the proxy is now. False where the tool presses on a contact that cannot be followed; what
/// it does not press on is let go.
bool Proxy::refresh(const Surface& surface, const Way& way) {
    bool followed = true;
    m_contacts.refresh([&](Foot& foot) {
        Foot to;
        const Tracked said = track(surface, m_position, foot, to);
        if (said == Tracked::Found ||
            (said == Tracked::Turned && gapOf(to, m_position, m_tool.radius) > -touching * foot.unit)) {
            foot = to;
            return true;
        }
        const bool pressed =
            gapOf(foot, way.from, m_tool.radius) <= touching * foot.unit && gapOf(foot, way.tool, m_tool.radius) < 0;
        // rims are left by the smallest steps only, so that they are left where they are
        followed = followed && (!pressed || (way.smallest && said == Tracked::Ended));
        return false;
    });
    return followed;
}

/// Moves the proxy out of what it is in, and where it slid on one sheet with the tool behind, back onto that.
void Proxy::settle(const Surface& surface, const Way& way) {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds && !m_contacts.empty(); ++round) {
        const auto feet = m_contacts.feet();
        const double gap = gapOf(feet[0], m_position, m_tool.radius);
        if (feet.size() == 1) { // its foot stays what it is
            if (gap < 0 || (gapOf(feet[0], way.tool, m_tool.radius) < 0 && gap < longestStep * feet[0].unit))
                m_position -= feet[0].normal * gap;
            return;
        }
        std::array<HalfSpace, Contacts::most> spaces;
        std::size_t count = 0;
        for (const Foot& foot : feet)
            spaces[count++] = {foot.normal, -gapOf(foot, m_position, m_tool.radius)};
        double deepest = 0;
        for (const HalfSpace& each : std::span(spaces).first(count))
            deepest = std::max(deepest, each.offset);
        const Vec3d shift = nearestIn({spaces.data(), count}, {}).value_or(Vec3d{});
        if (length(shift) > mostShift * deepest) // between planes that nearly face each other
            return;
        const double least = 0.1 * touching * leastUnit();
        m_position += shift;
        if (lengthSq(shift) <= least * least || !refresh(surface, {m_position - shift, way.tool, false}))
            return;
    }
}

/// One step, if it leads nearer to the tool or finds another contact.
bool Proxy::go(const Surface& surface, const Vec3d& step, const Way& way) {
    const Vec3d to = way.from + step;
    std::optional<Foot> met;
    if (!crossesFreely(step))
        met = firstMet(surface, way.from, to, m_contacts.feet());
    m_position = to;
    if (met && m_tool.radius > 0) {
        const double high = met->height(way.from), low = met->height(to);
        m_position = way.from + step * (high > low ? std::clamp((high - m_tool.radius) / (high - low), 0.0, 1.0) : 0.0);
        if (Foot here; track(surface, m_position, *met, here) == Tracked::Found)
            met = here;
    } else if (met) {
        m_position = met->position;
    }
    if (!refresh(surface, way))
        return false;
    const std::size_t known = m_contacts.feet().size();
    if (met)
        m_contacts.add(*met, m_position);
    if (m_tool.radius > 0)
        m_surroundings.collect(surface, m_position, m_tool.radius, m_contacts);
    const bool found = m_contacts.feet().size() > known;
    settle(surface, way);
    m_contacts.refresh([&](const Foot& foot) {
        return gapOf(foot, m_position, m_tool.radius) <= (m_tool.radius > 0 ? longestStep : released) * foot.unit;
    });
    return found || distanceSq(m_position, way.tool) < distanceSq(way.from, way.tool);
}

/// The step or as much of it as leads nearer to the tool.
bool Proxy::advance(const Surface& surface, Vec3d step, const Vec3d& x) {
    constexpr int halvings = 7;
    const Vec3d before = m_position;
    const Contacts contacts = m_contacts;
    for (int i = 0; i < halvings && m_stepsLeft > 0; ++i, step *= 0.5) {
        --m_stepsLeft;
        if (go(surface, step, {before, x, i + 1 == halvings}))
            return true;
        m_position = before;
        m_contacts = contacts;
    }
    return false;
}

void Proxy::move(const Surface& surface, const Vec3d& x) {
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * length(x);
    for (m_stepsLeft = m_mostSteps; m_stepsLeft > 0;) { // what is left is done in the next tick
        const Vec3d step = stepTo(x);
        const double least = m_contacts.empty() ? rounding : std::max(rounding, done * leastUnit());
        if (length(step) <= least || !advance(surface, step, x))
            break;
    }
    const Pull pull = pullOf(x);
    m_depth = pull.contacts > 0 ? length(pull.reaction) : 0;
    m_normal = m_depth > 0 ? pull.reaction / m_depth : Vec3d{};
}

void Proxy::place(const Surface& surface, const Vec3d& x) {
    m_placed = true;
    m_position = x;
    m_depth = 0;
    m_contacts.clear();
    if (std::optional<Foot> foot = nearestFoot(surface, x)) {
        constexpr double on = 1e-4; // of h: the side is nobody's business
        const bool near = distance(foot->position, x) <= on * foot->unit;
        const bool inside = foot->side < 0 && hasInside(surface) && (near || seesBacks(surface, x, *foot));
        if (inside) {
            foot->turn();
            m_position = foot->position + foot->normal * m_tool.radius;
        }
        if (inside || near)
            m_contacts.add(*foot, m_position);
    }
    if (m_tool.radius > 0)
        m_surroundings.collect(surface, m_position, m_tool.radius, m_contacts);
    settle(surface, {m_position, m_position, false});
}

void Proxy::follow(const Surface& before, const Surface& now) {
    if (!m_placed || before.tree() == now.tree())
        return;
    if (m_contacts.empty()) // the nearest sheet tells which side the proxy is on
        if (const std::optional<Foot> foot = nearestFoot(before, m_position))
            m_contacts.add(*foot, m_position);
    m_contacts.refresh([&](Foot& foot) {
        const std::optional<Foot> there = carried(now, foot);
        foot = there.value_or(foot);
        return there.has_value();
    });
    if (m_tool.radius > 0)
        m_surroundings.collect(now, m_position, m_tool.radius, m_contacts);
    settle(now, {m_position, m_position, false});
}

} // namespace haptics
