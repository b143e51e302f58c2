#include "core/sculpt/tools/layer_feet.h"

#include "core/surface/projection/project.h"

#include <limits>

namespace sculpt {

/// A step so long, in units of h, is none that one Newton step does well.
constexpr float longest = 0.25f;
/// A foot is one where its place lies no farther beside it, in units of h; after so many tries what is found will do.
constexpr float besides = 0.005f;
constexpr int rounds = 5;

static surface::ProjectOptions projecting() {
    surface::ProjectOptions out;
    out.tolerance = 1e-5;
    out.checkBoundary = false;
    return out;
}

static std::optional<LayerFoot> footAt(const base::Vec3f& foot, const surface::Evaluationf& at) {
    LayerFoot out{foot, normalized(at.gradient), {}};
    if (out.normal == base::Vec3f{})
        return {};
    const base::Mat3f flat = base::Mat3f::identity() - outer(out.normal, out.normal);
    out.bend = flat * (dot(at.normal, out.normal) < 0 ? at.normalGradient * -1.0f : at.normalGradient) * flat;
    return out;
}

/// One step from x.
static std::optional<LayerFoot> stepped(const base::Vec3f& x, const surface::Evaluationf& at) {
    const float slopeSq = dot(at.gradient, at.gradient);
    const bool there = at.ok() || at.status == surface::Status::BeyondBoundary;
    if (!there || !(slopeSq > 0) || !(at.value * at.value < longest * longest * at.unit * at.unit * slopeSq))
        return {};
    return footAt(x - at.gradient * (at.value / slopeSq), at);
}

namespace {

/// A foot that is looked for from `x`.
struct Sought {
    std::size_t of;
    base::Vec3f x;
    float aside = std::numeric_limits<float>::infinity(); ///< how far beside the foot its place lies
};

/// Takes the foot below `each.x` where the place is less beside it than beside the one before. True: go on from there.
bool improve(const base::Vec3f& place, const surface::Evaluationf& at, Sought& each, std::optional<LayerFoot>& best) {
    const std::optional<LayerFoot> found = stepped(each.x, at);
    if (!found)
        return false;
    const base::Vec3f up = place - found->foot, along = up - found->normal * dot(found->normal, up);
    const float before = each.aside;
    each.aside = length(along);
    if (!(each.aside < before))
        return false;
    best = found;
    each.x = found->foot + along;
    return each.aside > besides * at.unit;
}

} // namespace

std::vector<std::optional<LayerFoot>> layerFeet(const surface::Surface& first, std::span<const base::Vec3f> started,
                                                std::span<const base::Vec3f> places) {
    std::vector<std::optional<LayerFoot>> out(started.size());
    std::vector<Sought> sought(started.size());
    for (std::size_t i = 0; i < sought.size(); ++i)
        sought[i] = {i, started[i]};
    std::vector<base::Vec3f> x;
    std::vector<surface::Evaluationf> at;
    for (int round = 0; round < rounds && !sought.empty(); ++round) {
        x.clear();
        for (const Sought& each : sought)
            x.push_back(each.x);
        at.resize(x.size());
        first.evaluate(x, surface::Need::Gradient, at);
        std::size_t kept = 0;
        for (std::size_t k = 0; k < sought.size(); ++k)
            if (improve(places[sought[k].of], at[k], sought[k], out[sought[k].of]))
                sought[kept++] = sought[k];
        sought.resize(kept);
    }
    std::vector<std::size_t> left;
    std::vector<base::Vec3f> far;
    for (std::size_t i = 0; i < out.size(); ++i)
        if (!out[i])
            left.push_back(i), far.push_back(places[i]);
    std::vector<surface::Projection<float>> feet(far.size());
    surface::project(first, far, projecting(), feet);
    for (std::size_t k = 0; k < left.size(); ++k)
        if (feet[k].ok())
            out[left[k]] = footAt(feet[k].foot, feet[k].at);
    return out;
}

std::optional<base::Vec3f> layerFoot(const surface::Surface& first, const base::Vec3f& place) {
    const surface::Projection<float> found = surface::project(first, place, projecting());
    return found.ok() ? std::optional(found.foot) : std::nullopt;
}

} // namespace sculpt
