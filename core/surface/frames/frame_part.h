// How a frame plugs into an evaluation: one function per precision and order of derivatives, found by the frame's row.
//
// A frame is a struct in a file of its own with a member template
//
//     static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at)    n; f is then the height over its plane, or
//     static Field<T, O> field(const Neighbourhood<T, O>& at)           n and f
//
// and one line that makes it a part: constinit const FramePart ApssPart = framePart<Apss>();
#pragma once

#include "core/surface/frames/height_field.h"

#include <tuple>

namespace surface {

template <class T, int O>
using FieldFunction = Field<T, O> (*)(Neighbourhood<T, O>&);

struct FramePart {
    std::tuple<FieldFunction<float, 0>, FieldFunction<float, 1>, FieldFunction<float, 2>, FieldFunction<double, 0>,
               FieldFunction<double, 1>, FieldFunction<double, 2>>
        functions;
};

/// f and n of the frame at a position. Where its normals have no common sign, the sums' normals are aligned with n.
template <class T, int O>
Field<T, O> fieldOf(const FramePart& part, Neighbourhood<T, O>& at) {
    return std::get<FieldFunction<T, O>>(part.functions)(at);
}

template <class P, class T, int O>
Field<T, O> fieldBy(Neighbourhood<T, O>& at) {
    if constexpr (requires { P::field(at); })
        return P::field(at);
    else
        return heightField(at, P::normal(at));
}

template <class P>
constexpr FramePart framePart() {
    return {{&fieldBy<P, float, 0>, &fieldBy<P, float, 1>, &fieldBy<P, float, 2>, &fieldBy<P, double, 0>,
             &fieldBy<P, double, 1>, &fieldBy<P, double, 2>}};
}

} // namespace surface
