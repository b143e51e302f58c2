// Robust implicit moving least squares [Oeztireli09] (surface/README 2.9):
// f = sum w_i n_i.(x - p_i) / sum w_i with w_i = theta_i b_i, b_i = 1 in the first pass and then
// exp(-|n_i - g|^2 / sigma^2) by the gradient g of the pass before. Gradient and Hessian are the exact derivatives of
// the last pass's f with its b_i held constant; n is the sum of w_i n_i, normalised.
#include "core/surface/frames/frame_part.h"

namespace surface {

namespace {

constexpr int refitPasses = 3;      ///< the first without factors
constexpr double refitStill = 1e-3; ///< |g - g_before|^2 that ends them

struct Rimls {
    template <class T, int O>
    static Field<T, O> field(const Neighbourhood<T, O>& at) {
        constexpr int P = O < 1 ? 1 : O; // g leads from pass to pass, whatever is asked for
        SumOptions options = at.options;
        options.sigma = at.definition().rimlsSigma;
        Moments<T, P> m;
        Jet<T, P> f;
        base::Vec3<T> g;
        for (int pass = 0; pass < refitPasses; ++pass) {
            if (pass == 0)
                at.sheet.sum(at.clusters, at.x, options, m);
            else
                sum(at.clusters, at.x, options, m);
            if (!(m.one.v > leastWeight<T>))
                return {{}, {}, Cause::CancellingNormals};
            f = movingHeight(m) * inverse(m.one);
            const base::Vec3<T> now{f.d[0], f.d[1], f.d[2]};
            if (!(lengthSq(now - g) > T(refitStill)))
                break;
            g = now;
            options.facing = Facing::Refit;
            options.reference = base::cast<double>(g);
        }
        JetVec<T, O> normals;
        for (std::size_t a = 0; a < 3; ++a)
            normals[a] = truncated<O>(m.n[a]);
        const FrameNormal<T, O> n = normalisedSum(normals);
        return {truncated<O>(f), n.n, n.valid ? Cause::None : n.cause};
    }
};

} // namespace

constinit const FramePart RimlsPart = framePart<Rimls>();

} // namespace surface
