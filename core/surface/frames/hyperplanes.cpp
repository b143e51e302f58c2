// The dominant eigenvector of sum theta n_i n_i^T, which signs of normals leave alone [Adamson07, 2.4].
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

struct Hyperplanes {
    template <class T, int O>
    static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at) {
        return eigenvector(at.moments.outer, Pick::Largest);
    }
};

} // namespace

constinit const FramePart HyperplanesPart = framePart<Hyperplanes>();

} // namespace surface
