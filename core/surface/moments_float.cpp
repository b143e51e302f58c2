#include "core/surface/moments_float.h"

#include <cassert>

namespace surface {

template <int O>
static void spread(const float* s, Moments<float, O>& out) {
    out.one.v = s[0];
    out.height.v = s[7];
    for (int k = 0; k < 3; ++k) {
        out.q[k].v = s[1 + k];
        out.n[k].v = s[4 + k];
    }
    if constexpr (O >= 1)
        for (int k = 0; k < 3; ++k) {
            out.one.d[k] = s[9 + k];
            out.height.d[k] = s[27 + k];
            for (int l = 0; l < 3; ++l) {
                out.q[l].d[k] = s[12 + sym(k, l)];
                out.n[l].d[k] = s[18 + 3 * l + k];
            }
        }
}

template <int O>
static void spreadOuter(const float* s, Outer outer, Moments<float, O>& out) {
    for (int k = 0; k < 3; ++k)
        for (int l = k; l < 3; ++l) {
            auto& jet = out.outer[sym(k, l)];
            jet.v = s[sym(k, l)];
            if constexpr (O >= 1)
                for (int j = 0; j < 3; ++j)
                    jet.d[j] = s[6 + (outer == Outer::Normals ? 3 * sym(k, l) + j : sym3(j, k, l))];
        }
}

template <int O>
void sum(ClusterSpan clusters, const base::Vec3f& x, const SumOptions& options, Moments<float, O>& out) {
    static_assert(sumCount(1, Outer::Normals) <= maxSums && maxSums % 4 == 0);
    const base::Vec3f reference = base::cast<float>(options.reference);
    const KernelInput in{clusters.data(), clusters.size(), {x.x, x.y, x.z},
                         options.weight,  options.facing,  {reference.x, reference.y, reference.z}};
    alignas(64) float sums[maxSums];
    out.samples = sumKernel(O, options.outer, in, sums);
    out.unit = options.weight == Weight::Gaussian ? sums[8] / gaussianReach : sums[8];
    spread(sums, out);
    if (options.outer != Outer::None)
        spreadOuter(sums + (O == 0 ? sumsOfOrder0 : sumsOfOrder1), options.outer, out);
}

template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 0>&);
template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 1>&);

} // namespace surface
