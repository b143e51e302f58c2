#include "core/surface/evaluation/moments_float.h"

namespace surface {

/// The jet of one monomial from its sums with every factor.
template <int O>
static Jet<float, O> jetOf(const float* sums, int monomial) {
    const float* s = sums + monomial * factorCount(O);
    if constexpr (O == 0) {
        Jet<float, O> out;
        out.v = s[ThetaFactor];
        return out;
    } else {
        static_assert(ThetaFactor == 0 && SlopeFactor == 1);
        const Four first{s[0], s[1], s[2], s[3]};
        if constexpr (O == 1)
            return jet_lanes::jet<O>(first);
        const float plain = s[PlainSlopeFactor];
        const float* b = s + BendFactor; // 00 01 02 11 12 22
        return jet_lanes::jet<O>(first, Four{b[0], b[1], b[2], b[3]} - Four{plain, 0, 0, plain},
                                 Four{b[4], b[5], 0, 0} - Four{0, plain, 0, 0});
    }
}

KernelInput kernelInput(ClusterSpan clusters, const base::Vec3f& x, const SumOptions& options) {
    const base::Vec3f reference = base::cast<float>(options.reference);
    return {clusters.data(),       clusters.size(),
            {x.x, x.y, x.z},       options.weight,
            options.facing,        {reference.x, reference.y, reference.z},
            options.scale,         1 / (options.sigma * options.sigma),
            options.interpolating, options.axis,
            options.shape};
}

template <int O>
void sum(const KernelInput& in, Outer outer, Moments<float, O>& out) {
    static_assert(sumCount(2, Outer::Normals) <= maxSums && maxSums % 8 == 0);
    alignas(64) float sums[maxSums];
    out.samples = sumKernel(O, outer, in, sums);
    out.unit = unitOf(in.weight, sums[factorCount(O) * monomialCount(outer)]);
    out.one = jetOf<O>(sums, OneTerm);
    out.height = jetOf<O>(sums, HeightTerm);
    out.square = jetOf<O>(sums, SquareTerm);
    for (int k = 0; k < 3; ++k) {
        out.q[static_cast<std::size_t>(k)] = jetOf<O>(sums, QTerm + k);
        out.n[static_cast<std::size_t>(k)] = jetOf<O>(sums, NTerm + k);
    }
    if (outer != Outer::None)
        for (int k = 0; k < 6; ++k)
            out.outer[k] = jetOf<O>(sums, OuterTerm + k);
}

template <int O>
void sum(ClusterSpan clusters, const base::Vec3f& x, const SumOptions& options, Moments<float, O>& out) {
    sum(kernelInput(clusters, x, options), options.outer, out);
}

template void sum(const KernelInput&, Outer, Moments<float, 0>&);
template void sum(const KernelInput&, Outer, Moments<float, 1>&);
template void sum(const KernelInput&, Outer, Moments<float, 2>&);
template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 0>&);
template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 1>&);
template void sum(ClusterSpan, const base::Vec3f&, const SumOptions&, Moments<float, 2>&);

} // namespace surface
