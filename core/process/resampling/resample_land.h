// Landing on the frozen surface from nearby: gradient-orthogonal Newton steps, with the bias term. Internal to
// resample.
//
//     y <- x0 - g (f_c + g.(x0 - y)) / |g|^2,    f_c = f + (1 - mu) e^T (grad n) e,   e = y - c(y)
//
// f_c is what f would be if the samples were centred around y: it removes the drift that the symmetric form leaves when
// it projects uneven samples (process/README 4.3).
#pragma once

#include "core/surface/evaluation/source.h"

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

/// One step more from x0, where `out.place` is the last one's end, or x0 to begin with. False: no surface there.
bool landStep(surface::Source& source, const base::Vec3f& x0, const base::Vec3f& hint, Landing& out);

/// At most `steps` steps from x0, until one is shorter than `tolerance` (model units). Not ok: no surface there.
/// REQUIRES: steps >= 1.
/// What lands with one source one after the other should lie side by side.
Landing land(surface::Source& source, const base::Vec3f& x0, const base::Vec3f& hint, int steps, float tolerance);

} // namespace process
