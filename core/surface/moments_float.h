// The vectorised sums as the kernel leaves them: one float per sum, in the order below. Internal to the room.
#pragma once

#include "core/surface/moments.h"

#include <cstddef>

namespace surface {

/// Order of the sums: those of order 0, of order 1, then the outer products of order 0 and 1.
///     0 theta   1 theta q (3)   4 theta n (3)   7 theta n.q   8 theta h
///     9 a q (3)   12 a q q (6, symmetric)   18 a n q (9, row n)   27 a (n.q) q (3)
///     then  theta y y (6);  a n n q (18, n n by `sym`, then q)  or  a q q q (10, symmetric)
constexpr int sumsOfOrder0 = 9, sumsOfOrder1 = 30;
constexpr int sumCount(int order, Outer outer) {
    const int plain = order == 0 ? sumsOfOrder0 : sumsOfOrder1;
    if (outer == Outer::None)
        return plain;
    return plain + 6 + (order == 0 ? 0 : outer == Outer::Normals ? 18 : 10);
}
constexpr int maxSums = 56; // a multiple of 4 above sumCount(1, Outer::Normals)

/// Entry of a symmetric tensor of order three among its ten: 000 001 002 011 012 022 111 112 122 222.
constexpr int sym3(int j, int k, int l) {
    const int ones = (j == 1) + (k == 1) + (l == 1), twos = (j == 2) + (k == 2) + (l == 2);
    constexpr int place[4][4] = {{0, 2, 5, 9}, {1, 4, 8, 0}, {3, 7, 0, 0}, {6, 0, 0, 0}};
    return place[ones][twos];
}

struct KernelInput {
    const float* const* clusters;
    std::size_t clusterCount;
    float x[3];
    Weight weight;
    Facing facing;
    float reference[3];
};

/// Sums over all clusters into sums[0, sumCount(order, outer)); returns the number of surfels with weight.
int sumKernel(int order, Outer outer, const KernelInput& in, float* sums);

} // namespace surface
