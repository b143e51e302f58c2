#include "core/surface/segments.h"

#include "core/surface/ray_policy.h"

namespace surface {

using base::Vec3d;

struct SegmentCaster::State {
    explicit State(const Surface& surface)
        : setting(surface, {}), sources(surface), slack(3e-5 * double(setting.maxSupport)) {
        constexpr float reach = 1.05f; // of the support: surface bounds reach no further than this from positions
        const base::Box3f near = surface.tree().bounds().inflated(reach * setting.maxSupport);
        bounds = {base::cast<double>(near.lo), base::cast<double>(near.hi)};
    }
    std::optional<double> first(const base::Rayd& line, double from, double to);
    bool entersFrom(const Vec3d& end, const Vec3d& along) const;

    RaySetting setting;
    RaySources sources;
    double slack; ///< some times the precision of floats: roots this close to an end are decided there
    base::Box3d bounds;
};

/// The first root between two places on a line.
std::optional<double> SegmentCaster::State::first(const base::Rayd& line, double from, double to) {
    const auto [enter, leave] = base::clip(base::Rayd{line.at(from), line.direction}, bounds);
    const double length = std::min(leave, to - from);
    if (!(enter < length))
        return std::nullopt;
    // From where the bounds begin, so that floats are fine enough; discs that lead to a root may be crossed behind it.
    const base::Rayf ray{base::cast<float>(line.at(from + enter)), base::cast<float>(line.direction)};
    setting.options.tMax = static_cast<float>(length - enter) + setting.maxSupport;
    RayPolicy<float> policy(setting, sources, ray);
    RayHit<float> hit;
    policy.first(hit);
    const double t = from + enter + double(hit.t);
    return hit.hit && t <= to ? std::optional(t) : std::nullopt;
}

/// Does what begins at an end on the surface, to rounding, go through the surface?
bool SegmentCaster::State::entersFrom(const Vec3d& end, const Vec3d& along) const {
    const Evaluationd e = setting.surface.evaluateReference(end);
    const double slope = dot(e.gradient, along);
    return e.value < 0 ? slope > 0 : slope < 0;
}

SegmentCaster::SegmentCaster(const Surface& surface) : m_state(std::make_unique<State>(surface)) {}
SegmentCaster::~SegmentCaster() = default;

static bool before(const Vec3d& a, const Vec3d& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

std::optional<Vec3d> SegmentCaster::meet(const Vec3d& a, const Vec3d& b) const {
    const Vec3d low = before(a, b) ? a : b, high = before(a, b) ? b : a;
    const base::Rayd line{low, base::normalized(high - low)};
    const double length = distance(low, high), slack = m_state->slack;
    for (double from = -slack; from < length; from = slack) {
        const auto t = m_state->first(line, from, length + slack);
        if (!t)
            return std::nullopt;
        const bool atLow = *t<slack, atHigh = *t> length - slack;
        if ((!atLow || m_state->entersFrom(low, line.direction)) &&
            (!atHigh || m_state->entersFrom(high, -line.direction)))
            return line.at(std::clamp(*t, 0.0, length));
        if (!atLow || atHigh || from > 0)
            return std::nullopt;
    }
    return std::nullopt;
}

} // namespace surface
