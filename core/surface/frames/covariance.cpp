// The least eigenvector of the covariance about x, sum theta (x - p_i)(x - p_i)^T [Adamson07, 2.4].
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

/// Seen from beside a line of points, x and the line span a plane that is nothing but an accident: whether the points
/// are on a line is asked about their centroid (surface/README 2.5).
template <class T, int O>
bool onLine(const Moments<T, O>& m) {
    const base::Vec3<T> e = valueOf(m.q) / m.one.v;
    T about[6];
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b)
            about[sym(a, b)] =
                m.outer[sym(a, b)].v - m.one.v * e[static_cast<std::size_t>(a)] * e[static_cast<std::size_t>(b)];
    const base::SymmetricEigen<T> eigen = base::symmetricEigen(detail::matrixOf(about));
    return !(eigen.value[1] >= T(collinearBelow) * eigen.value[2]);
}

struct Covariance {
    template <class T, int O>
    static FrameNormal<T, O> normal(const Neighbourhood<T, O>& at) {
        if (onLine(at.moments))
            return {{}, false, Cause::Collinear};
        Jet<T, O> s[6];
        movingOuter(at.moments, s);
        FrameNormal<T, O> out = eigenvector(s, Pick::Smallest);
        if (out.cause == Cause::Collinear)
            out.cause = Cause::ClosedGap;
        return out;
    }
};

} // namespace

constinit const FramePart CovariancePart = framePart<Covariance>();

} // namespace surface
