// One position of graded fields and its neighbours, side by side in lanes: how far the fields may fall on the way to
// each, and where they fall farther (process/README 1.3).
#pragma once

#include "core/process/neighbours/neighbour_table.h"

namespace process {

/// Working memory of one thread.
struct GradedRow {
    static constexpr std::size_t lanes = 16, mostFields = 2;
    static_assert(NeighbourTable::most <= lanes);

    base::Vec3f position;
    alignas(64) float x[lanes] = {};
    alignas(64) float y[lanes] = {};
    alignas(64) float z[lanes] = {};
    alignas(64) float value[mostFields][lanes] = {}; ///< of each field at the neighbours
    float own[mostFields] = {};                      ///< of each field at the position

    alignas(64) float drop[lanes];   ///< what a field may fall by on the way to each
    float wanted[mostFields];        ///< least value here that no neighbour stands too high above
    std::uint32_t below[mostFields]; ///< a bit for each neighbour that lies too far below what is wanted here
};

/// Fills in the rest. REQUIRES: 1 <= count <= lanes, of neighbours; no value that is not a number.
void judgeRow(GradedRow& row, std::size_t count, std::size_t fields, float slope);

} // namespace process
