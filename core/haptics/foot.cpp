#include "core/haptics/foot.h"

#include "core/surface/projection/foot_step.h"
#include "core/surface/projection/project.h"
#include "core/surface/rays/intersect.h"

#include <algorithm>

namespace haptics {

using base::Vec3d, surface::Status, surface::Surface;
using Evaluation = surface::Evaluationd;

namespace {

constexpr double turned = 0.5;          ///< cosine of the largest turn of a normal in one go
constexpr double leastEigenvalue = 0.5; ///< of Newton's matrix: a step is at most twice the plain one
constexpr double longest = 0.25;        ///< of h: a step along the surface or across it
constexpr double settled = 1e-5;        ///< of h: what is left after such a step is its square
constexpr double hair = 1e-6;           ///< of h

Vec3d shortened(const Vec3d& v, double most) {
    const double l = length(v);
    return l > most ? v * (most / l) : v;
}

/// What an evaluation says at a place that should be close to the surface.
Tracked verdict(const Evaluation& at) {
    if (at.status == Status::Outside || at.status == Status::BeyondBoundary)
        return Tracked::Ended;
    if (!at.ok())
        return Tracked::Lost;
    if (at.offCentre > surface::maxOffCentre * at.unit)
        return Tracked::Ended;
    return dot(at.normal, at.gradient) >= surface::minSlope ? Tracked::Found : Tracked::Lost;
}

bool usable(const Evaluation& at) {
    return (at.ok() || at.status == Status::BeyondBoundary) && lengthSq(at.gradient) > 0.01;
}

Foot footAt(const Vec3d& position, const Vec3d& normal, double side, const Evaluation& at) {
    return {position, normal, side, at.unit, at.agreement, at.normalGradient * side};
}

} // namespace

void Foot::turn() {
    normal = -normal;
    side = -side;
    bend *= -1;
}

base::Mat3d Foot::bendAt(double radius) const {
    if (radius == 0)
        return bend;
    const base::Mat3d wider = base::Mat3d::identity() + bend * radius;
    return determinant(wider) > 0.05 ? bend * inverse(wider) : bend;
}

Tracked track(const Surface& surface, const Vec3d& x, const Foot& from, Foot& out) {
    constexpr int most = 20;
    const Vec3d across = x - from.position;
    Vec3d y = from.position + shortened(across - from.normal * dot(across, from.normal), 2 * longest * from.unit);
    const bool oriented = surface.tree().layout()->oriented; // then another side is another sheet
    Vec3d normal = from.normal;
    double side = from.side;
    for (int i = 0; i < most; ++i) {
        const base::Vec3f own = base::cast<float>(oriented ? normal * side : normal);
        const Evaluation at = surface.evaluateReference(y, surface::Need::Gradient, {own});
        if (!usable(at))
            return at.status == Status::Outside ? Tracked::Ended : Tracked::Lost;
        const double slope = length(at.gradient);
        if (!oriented)
            side = dot(at.gradient, normal) < 0 ? -1 : 1;
        normal = at.gradient * (side / slope);
        const double high = dot(x - y, normal);
        surface::TangentMatrix<double> matrix(normal);
        matrix.add(at.normalGradient, side * high);
        const Vec3d along = shortened(matrix.solve(x - y - normal * high, leastEigenvalue), longest * at.unit);
        const double down = std::clamp(side * at.value / slope, -longest * at.unit, longest * at.unit);
        y += along - normal * down;
        if (lengthSq(along) + down * down <= settled * settled * at.unit * at.unit) {
            const Tracked said = verdict(at);
            out = footAt(y, base::normalized(normal + at.normalGradient * along * side), side, at);
            return said == Tracked::Found && dot(out.normal, from.normal) < turned ? Tracked::Turned : said;
        }
        if (distance(y, from.position) > length(across) + from.unit)
            return Tracked::Lost;
    }
    return Tracked::Lost;
}

std::optional<Foot> firstMet(const Surface& surface, const Vec3d& from, const Vec3d& to, std::span<const Foot> own) {
    Vec3d start = from;
    for (const Foot& foot : own)
        start += foot.normal * std::max(0.0, hair * foot.unit - foot.height(start));
    const double far = distance(start, to);
    if (!(far > 0))
        return std::nullopt;
    surface::IntersectOptions options;
    options.tMax = static_cast<float>(far) * 1.000001f;
    const auto hit = surface::intersectReference(surface, {start, (to - start) / far}, options);
    if (!hit.hit)
        return std::nullopt;
    const Foot met{hit.position, hit.normal, dot(hit.normal, hit.outward) < 0 ? -1.0 : 1.0, hit.unit, hit.agreement};
    for (const Foot& foot : own)
        if (far <= 2 * longest * foot.unit && distance(met.position, foot.position) <= 2 * longest * foot.unit &&
            dot(met.normal, foot.normal) >= turned)
            return std::nullopt;
    Foot exact;
    return track(surface, met.position, met, exact) == Tracked::Found ? exact : met;
}

/// What is met on the way to the nearest surfel and a little on: near the middle of a ball no foot is the nearest.
static std::optional<Foot> towardsNearestSurfel(const Surface& surface, const Vec3d& x) {
    std::vector<tree::Neighbour> found;
    surface.tree().nearest(base::cast<float>(x), 1, found);
    if (found.empty())
        return std::nullopt;
    const Vec3d p = base::cast<double>(found[0].block->position(found[0].slot));
    return firstMet(surface, x, p + (p - x) * 0.1, {});
}

std::optional<Foot> nearestFoot(const Surface& surface, const Vec3d& x) {
    const auto found = surface::projectReference(surface, x);
    if (!found.ok() || !usable(found.at))
        return towardsNearestSurfel(surface, x);
    const double side = dot(x - found.foot, found.at.gradient) < 0 ? -1 : 1;
    return footAt(found.foot, base::normalized(found.at.gradient) * side, side, found.at);
}

std::optional<Foot> carried(const Surface& now, const Foot& before) {
    constexpr double far = 64; // of h: what a dab or two can move
    Foot foot;
    if (track(now, before.position, before, foot) == Tracked::Found &&
        distance(foot.position, before.position) < longest * before.unit)
        return foot;
    std::optional<Foot> best;
    surface::IntersectOptions options;
    options.tMax = static_cast<float>(far * before.unit);
    for (const Vec3d& direction : {before.normal, -before.normal})
        for (const auto& hit : intersectAllReference(now, {before.position, direction}, options)) {
            if (dot(hit.outward, before.normal) * before.side < 0.2)
                continue; // it faces the other way: what is behind or opposite
            const Foot start{hit.position, hit.outward * before.side, before.side, hit.unit, hit.agreement};
            if (track(now, hit.position, start, foot) != Tracked::Found)
                foot = start;
            if (!best || distanceSq(foot.position, before.position) < distanceSq(best->position, before.position))
                best = foot;
            break;
        }
    return best;
}

} // namespace haptics
