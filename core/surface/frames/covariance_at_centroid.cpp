// The covariance frame evaluated at y = c(x), weights and centre, and composed with c [Adamson07, 2.4].
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

struct CovarianceAtCentroid {
    template <class T, int O>
    static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at) {
        SumOptions options = at.options;
        options.outer = Outer::Offsets;
        Moments<T, O> there;
        const base::Vec3<T> y = at.centroidPosition();
        ScratchClusters clusters;
        at.source.gather(y, clusters.list());
        at.sheet.sum(clusters.span(), y, options, there);
        if (const Cause cause = scarcity(clusters.span(), y, options, there); cause != Cause::None)
            return {{}, false, cause};
        Jet<T, O> s[6];
        movingOuter(there, s);
        FrameNormal<T, O> out = eigenvector(s, Pick::Smallest);
        if (out.valid)
            for (Jet<T, O>& each : out.n)
                each = compose(each, at.centroid);
        return out;
    }
};

} // namespace

constinit const FramePart CovarianceAtCentroidPart = framePart<CovarianceAtCentroid>();

} // namespace surface
