// The parts of the sums in double that are done in lanes (moments_double.cpp). The same operations on every number in
// the same order as one by one, hence the same bits on every machine. Internal to the room.
#pragma once

#include "core/surface/evaluation/moments.h"

namespace surface {

/// Bits of the surfels of a cluster whose supports, balls times `scale`, hold x.
unsigned holdingKernel(const float* cluster, const base::Vec3d& x, double scale);

/// Jets and what they are multiplied by, for some surfels in a row.
struct DoubleFactors {
    static constexpr std::size_t width = 16;  ///< numbers of a jet of order 2, and room for whole registers
    static constexpr std::size_t terms = 15;  ///< 1, q, n, n.q, |q|^2 and a product of two
    static constexpr std::size_t atOnce = 32; ///< surfels
    alignas(64) double jet[atOnce][width];
    double term[atOnce][terms];
};

/// sums[t] += jet[i] * term[i][t] for the first `count` surfels, one after the other, of the first `terms` and the
/// first `width` numbers: a multiple of 4.
void productKernel(const DoubleFactors& factors, std::size_t count, std::size_t terms, std::size_t width,
                   double (*sums)[DoubleFactors::width]);

} // namespace surface
