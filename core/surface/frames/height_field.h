// f as the height over the plane of a frame's normal, in the shrink-free family (surface/README 2.6).
#pragma once

#include "core/surface/evaluation/neighbourhood.h"
#include "core/surface/frames/frame_normal.h"

namespace surface {

/// f with the normal of its tangent object: the plane, or the sphere at x. `cause` says why there is none.
template <class T, int O>
struct Field {
    Jet<T, O> f;
    JetVec<T, O> n{};
    Cause cause = Cause::None;
};

/// The sign of n: by the surfels' normals where they are oriented, else by the hint, else as it came.
template <class T, int O>
void orient(const Neighbourhood<T, O>& at, JetVec<T, O>& n) {
    const base::Vec3<T> reference = at.oriented ? valueOf(at.moments.n) : base::cast<T>(at.side);
    if (dot(valueOf(n), reference) < T(0))
        n = n * T(-1);
}

/// Normals without a common sign, summed once more on n's side.
template <class T, int O>
void alignNormals(Neighbourhood<T, O>& at, const JetVec<T, O>& n) {
    SumOptions options = at.options;
    options.outer = Outer::None;
    options.facing = Facing::Flip;
    options.reference = base::cast<double>(valueOf(n));
    Moments<T, O> aligned;
    sum(at.clusters, at.x, options, aligned);
    at.moments.n = aligned.n;
    at.moments.height = aligned.height;
    at.agreement = agreementOf(at.moments);
}

/// f = (1-mu) n.(x - c) + mu sum theta n_i.(x - p_i) / w.
template <class T, int O>
Field<T, O> heightField(Neighbourhood<T, O>& at, FrameNormal<T, O> frame) {
    if (!frame.valid)
        return {{}, {}, frame.cause};
    orient(at, frame.n);
    if (at.normals && !at.oriented)
        alignNormals(at, frame.n);
    const T mu = at.normals ? static_cast<T>(at.definition().mu()) : T(0);
    Field<T, O> out{dot(frame.n, at.d) * (T(1) - mu), frame.n, Cause::None};
    if (mu > T(0))
        out.f += movingHeight(at.moments) * at.inverseWeight * mu;
    return out;
}

} // namespace surface
