// The least left singular vector of J = grad c [Adamson07, 2.2]: the direction in which the centroid cannot move.
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

struct CentroidGradient {
    /// Third derivatives of weights are summed in double alone: whoever wants this frame's Hessian asks the reference
    /// (source.cpp).
    template <class T, int O>
    static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at) {
        if constexpr (O < 2 || std::is_same_v<T, double>) {
            Moments<T, O + 1> wide;
            at.sheet.sum(at.clusters, at.x, at.options, wide);
            Jet<T, O> s[6];
            centroidGradientSquare(wide, s);
            return eigenvector(s, Pick::Smallest, Eigenvalues::Squares);
        } else {
            assert(!"the Hessian of centroid-gradient is the reference's");
            return {};
        }
    }
};

} // namespace

constinit const FramePart CentroidGradientPart = framePart<CentroidGradient>();

} // namespace surface
