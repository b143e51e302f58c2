// One step of orthogonal projections at 16 positions in lanes (surface/README 3.2, 8.1). Internal to the room.
//
// Lanes never meet, so that a position has the same bits in any company.
#pragma once

#include "core/surface/projection/near_lanes.h"

namespace surface {

struct FootOptions {
    Weight weight;
    float mu, tolerance;
    float leastAgreement, leastSpread; ///< below these a position is special
};

struct FootLanes {
    static constexpr std::size_t lanes = NearLanes::lanes;
    alignas(64) float from[3][lanes]; ///< what is projected
    float at[3][lanes];               ///< the iterate
    float lastSize[lanes];            ///< of the step that led there; infinity for none
    // found by the kernel
    float to[3][lanes], size[lanes];
    float samples[lanes], weight[lanes], value[lanes], unit[lanes], offCentre[lanes], agreement[lanes];
    float centroid[3][lanes], normal[3][lanes], gradient[3][lanes];
    float normalGradient[9][lanes];
    unsigned usual;   ///< bits: one sheet of enough surfels
    unsigned settled; ///< the step is below what counts as one
    unsigned onZero;  ///< f vanishes, as far as that
    unsigned leads;   ///< the step is to be trusted: short, shorter than the last, along a surface that hardly bends
};

/// Evaluates value and gradient at the iterates, and finds the step from each.
void footKernel(const FootOptions& options, const NearLanes& near, FootLanes& io);

} // namespace surface
