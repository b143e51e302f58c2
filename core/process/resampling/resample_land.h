// Landing on the frozen surface from nearby: gradient-orthogonal Newton steps, with the bias term. Internal to
// resample.
//
//     y <- x0 - g (f_c + g.(x0 - y)) / |g|^2,    f_c = f + (1 - mu) e^T (grad n) e,   e = y - c(y)
//
// f_c is what f would be if the samples were centred around y: it removes the drift that the symmetric form leaves when
// it projects uneven samples (process/README 4.3).
#pragma once

#include "core/surface/evaluation/together.h"

namespace process {

struct Landing {
    bool ok = false;
    float step = 0; ///< length of the last
    base::Vec3f place;
    base::Vec3f gradient; ///< unit, at the last place evaluated
    surface::Evaluationf at;
};

/// f_c of an evaluation at x with gradient.
float centredValue(const surface::Surface& surface, const base::Vec3f& x, const surface::Evaluationf& e);
float centredValue(const surface::Surface& surface, const surface::TogetherAt& e);

/// One step more from x0, where `out.place` is the last one's end, or x0 to begin with, and `at` is what the surface
/// is there. False: none.
bool landStep(const surface::Surface& surface, const base::Vec3f& x0, const surface::TogetherAt& at, Landing& out);

/// From each of x0 at most `steps` steps, until one is shorter than `tolerance` (model units). Not ok: no surface
/// there. What lies side by side should stand side by side. Of `at` they tell what TogetherAt does, but for the bend.
/// In parallel. REQUIRES: steps >= 1; as many hints.
std::vector<Landing> landTogether(const surface::Surface& surface, std::span<const base::Vec3f> x0,
                                  std::span<const base::Vec3f> hints, int steps, float tolerance);

} // namespace process
