#include "core/process/resampling/resample_land.h"

#include <cmath>

namespace process {

/// Below this slope f says nothing about distance (counts as outside).
constexpr float flattest = 0.05f;

float centredValue(const surface::Surface& surface, const base::Vec3f& x, const surface::Evaluationf& e) {
    const base::Vec3f off = x - e.centroid;
    return e.value + (1 - surface.definition().mu()) * dot(off, e.normalGradient * off);
}

bool landStep(surface::Source& source, const base::Vec3f& x0, const base::Vec3f& hint, Landing& out) {
    out.at = source.evaluate(out.place, surface::Need::Gradient, {hint});
    const float slope = length(out.at.gradient);
    const bool there = out.at.status == surface::Status::Ok || out.at.status == surface::Status::BeyondBoundary;
    if (!there || !(slope > flattest))
        return false;
    out.gradient = out.at.gradient / slope;
    const float value = centredValue(source.surface(), out.place, out.at) / slope;
    const base::Vec3f next = x0 - out.gradient * (value + dot(out.gradient, x0 - out.place));
    out.step = distance(next, out.place);
    out.place = next;
    out.ok = true;
    return true;
}

Landing land(surface::Source& source, const base::Vec3f& x0, const base::Vec3f& hint, int steps, float tolerance) {
    Landing out;
    out.place = x0;
    for (int k = 0; k < steps; ++k)
        if (!landStep(source, x0, hint, out) || out.step <= tolerance)
            break;
    return out;
}

} // namespace process
