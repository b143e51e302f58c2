// Even sampling of a surface by rows: curves at equal distance from each other, each with points at equal distances.
// The layout is close to hexagonal where neighbouring rows are about as long, and rows of any length join without gaps.
#pragma once

#include "core/surfel/surfel.h"

#include <functional>

namespace process {

/// A point of a row with its outward unit normal.
struct RowPoint {
    base::Vec3d position, normal;
};

/// A closed curve on the surface: its length and its point at a distance along it, 0 to length.
struct Row {
    double length = 0;
    std::function<RowPoint(double)> at;
};

/// Rows that cover a surface when their distance is about `distance`.
using RowMaker = std::function<std::vector<Row>(double distance)>;

/// Exactly `count` surfels with outward normals on the rows of a surface of this area.
surfel::SurfelList sampleRows(const RowMaker& rows, double area, std::size_t count);

} // namespace process
