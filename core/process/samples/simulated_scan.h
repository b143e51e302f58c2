// A simulated range scan: a little figure seen by several orthographic scanners, with everything that real scans have.
//
//     noise           along each scanner's rays, and a slight misalignment of each view against the others
//     uneven density  the scanners' pixels differ in size and views overlap in layers
//     missing parts   nothing looks from below, overhangs hide what is behind them, glancing rays give no answer, and
//                     dark spots swallow the light
//     no normals, no colours, no order
#pragma once

#include "core/surfel/surfel.h"

namespace process {

/// Exactly `count` points of a figure of about unit radius, y up.
surfel::SurfelList simulateScan(std::size_t count, std::uint64_t seed);

} // namespace process
