// The order of points along a Morton curve: by the code of their cell in a grid of 2^21 cells a side, within a cell by
// position, coincident ones by number, so that these stand together. In parallel, the same at any thread count.
//
// Points that stand in this order already cost a look at their codes. A list that is put in it once therefore spares
// all that comes later both the sort and memory read at random.
#pragma once

#include "core/base/large_array.h"
#include "core/process/neighbours/point_cells.h"
#include "core/surfel/surfel.h"

namespace process {

struct CurveOrder {
    /// REQUIRES: finite positions.
    explicit CurveOrder(std::span<const surfel::Surfel> points);

    CurveGrid grid;
    base::LargeArray<std::uint32_t> order; ///< numbers of the points; empty where they stand in this order already
};

/// Puts the points in that order, with what they carry. Returns the numbers that they had, empty where none moved.
/// REQUIRES: finite positions.
base::LargeArray<std::uint32_t> putInCurveOrder(surfel::SurfelList& points);

} // namespace process
