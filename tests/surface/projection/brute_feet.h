// Foot points by brute force in float64: the plain fixed-point iterations of surface/README 3.1, without restarts,
// damping or Newton's steps, over the evaluation of brute_force.h.
#pragma once

#include "core/surface/projection/project.h"
#include "surface/evaluation/brute_force.h"

namespace brute {

/// x -> b - v (f + n.(b - x)) / (n.v) until steps are below 1e-13 h: b the start, or x itself for basic ones; v the
/// gradient for orthogonal ones, else n. Frames without a sign keep that of `hint`. False where it does not converge.
inline bool project(const Model& model, const Vec3d& x0, surface::Projector projector, Vec3d& foot, Vec3d hint = {}) {
    foot = x0;
    for (int i = 0; i < 400; ++i) {
        const Answer a = evaluate(model, foot, hint);
        if (!a.valid)
            return false;
        if (!model.oriented)
            hint = a.n;
        const Vec3d back = projector == surface::Projector::Basic ? Vec3d{} : x0 - foot;
        const Vec3d along = projector == surface::Projector::Orthogonal ? a.g : a.n;
        const Vec3d step = back - along * ((a.f + dot(a.n, back)) / dot(a.n, along));
        foot += step;
        if (length(step) < 1e-13 * a.unit)
            return true;
    }
    return false;
}

} // namespace brute
