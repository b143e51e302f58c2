#include "core/process/resampling/resample_land.h"

#include "core/base/parallel.h"

#include <cmath>
#include <numeric>

namespace process {

using base::Vec3f;

/// Below this slope f says nothing about distance (counts as outside).
constexpr float flattest = 0.05f;

float centredValue(const surface::Surface& surface, const Vec3f& x, const surface::Evaluationf& e) {
    const Vec3f off = x - e.centroid;
    return e.value + (1 - surface.definition().mu()) * dot(off, e.normalGradient * off);
}

float centredValue(const surface::Surface& surface, const surface::TogetherAt& e) {
    return e.value + (1 - surface.definition().mu()) * e.bend;
}

/// With what `out.at` tells of `out.place`, where f_c is `centred`.
static bool step(const Vec3f& x0, float centred, Landing& out) {
    const float slope = length(out.at.gradient);
    const bool there = out.at.status == surface::Status::Ok || out.at.status == surface::Status::BeyondBoundary;
    if (!there || !(slope > flattest))
        return false;
    out.gradient = out.at.gradient / slope;
    const float value = centred / slope;
    const Vec3f next = x0 - out.gradient * (value + dot(out.gradient, x0 - out.place));
    out.step = distance(next, out.place);
    out.place = next;
    out.ok = true;
    return true;
}

static void take(const surface::TogetherAt& from, surface::Evaluationf& to) {
    to.status = from.status;
    to.value = from.value, to.unit = from.unit;
    to.offCentre = from.offCentre, to.agreement = from.agreement;
    to.centroid = from.centroid, to.gradient = from.gradient;
}

bool landStep(const surface::Surface& surface, const Vec3f& x0, const surface::TogetherAt& at, Landing& out) {
    take(at, out.at);
    return step(x0, centredValue(surface, at), out);
}

std::vector<Landing> landTogether(const surface::Surface& surface, std::span<const Vec3f> x0,
                                  std::span<const Vec3f> hints, int steps, float tolerance) {
    std::vector<Landing> out(x0.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i].place = x0[i];
    std::vector<std::uint32_t> left(x0.size());
    std::iota(left.begin(), left.end(), 0u);
    std::vector<Vec3f> places, sides;
    std::vector<surface::TogetherAt> at;
    std::vector<std::uint8_t> goesOn;
    for (int k = 0; k < steps && !left.empty(); ++k) {
        places.resize(left.size()), sides.resize(left.size()), at.resize(left.size()), goesOn.resize(left.size());
        for (std::size_t i = 0; i < left.size(); ++i)
            places[i] = out[left[i]].place, sides[i] = hints[left[i]];
        evaluateTogether(surface, places, sides, at);
        base::parallelFor(left.size(), 256, [&](std::size_t i) {
            Landing& each = out[left[i]];
            goesOn[i] = landStep(surface, x0[left[i]], at[i], each) && each.step > tolerance ? 1 : 0;
        });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < left.size(); ++i)
            if (goesOn[i])
                left[kept++] = left[i];
        left.resize(kept);
    }
    return out;
}

} // namespace process
