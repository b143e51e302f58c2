// The sum of oriented normals, normalised [Adamson07, 2.4].
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

struct Normals {
    template <class T, int O>
    static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at) {
        return normalisedSum(at.moments.n);
    }
};

} // namespace

constinit const FramePart NormalsPart = framePart<Normals>();

} // namespace surface
