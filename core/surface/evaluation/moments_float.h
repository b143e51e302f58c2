// The vectorised sums as the kernel leaves them: one float per sum. Internal to the room.
//
// Every sum is that of a factor times a monomial over the surfels with weight. With theta, a and b from
// theta_,k = a q_k and theta_,kl = b q_k q_l - a delta_kl:
//     factors      order 0: theta;   order 1: a q (3);   order 2: a, b q q (6, by `sym`)
// (for ellipsoids G takes the place of q in factors, and M that of delta: surface/README 2.1)
//     monomials    1, q (3), n (3), n.q, |q|^2;   with outer products: n n^T or q q^T (6, by `sym`)
// The sums stand monomial by monomial, each with all factors, so that those of order 1 are a jet; sum theta h is last.
#pragma once

#include "core/surface/evaluation/moments.h"

#include <cstddef>

namespace surface {

/// Places of the monomials.
enum Monomial : int { OneTerm, QTerm, NTerm = 4, HeightTerm = 7, SquareTerm = 8, OuterTerm = 9 };
constexpr int monomialCount(Outer outer) {
    return outer == Outer::None ? 9 : 15;
}
/// Places of the factors.
enum Factor : int { ThetaFactor, SlopeFactor, PlainSlopeFactor = 4, BendFactor = 5 };
constexpr int factorCount(int order) {
    return order == 0 ? 1 : order == 1 ? 4 : 11;
}
constexpr int sumCount(int order, Outer outer) {
    return factorCount(order) * monomialCount(outer) + 1;
}
constexpr int maxSums = 168; // a multiple of 8 that holds sumCount(2, Outer::Normals)

struct KernelInput {
    const float* const* clusters;
    std::size_t clusterCount;
    float x[3];
    Weight weight;
    Facing facing;
    float reference[3];
    float scale;              ///< of supports
    float inverseSigmaSquare; ///< of Facing::Refit
    bool interpolating;
    const Axis* axis; ///< of Facing::Part
    int shape;        ///< channel of shapes; 0: none
};

KernelInput kernelInput(ClusterSpan clusters, const base::Vec3f& x, const SumOptions& options);
template <int O>
void sum(const KernelInput& in, Outer outer, Moments<float, O>& out);

/// Sums over all clusters into sums[0, sumCount(order, outer)); returns the number of surfels with weight.
/// `sums` holds maxSums floats, 64-byte aligned.
int sumKernel(int order, Outer outer, const KernelInput& in, float* sums);

} // namespace surface
