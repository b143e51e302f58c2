// The neighbours that supports are compared with: of every distinct position the nearest on its own side.
#pragma once

#include "core/process/estimation/knn.h"

namespace process {

/// Two rings of a hexagonal layout have 18: the inner one and half the outer carry a slope in every direction.
inline constexpr std::size_t gradedNeighbours = 12;

/// Each position's neighbours with their distances, nearest first, `count` in a row. Who is whose neighbour is not
/// mutual: sparse places see dense ones that do not see them.
struct NeighbourGraph {
    std::size_t count = 0;
    std::vector<std::uint32_t> index;
    std::vector<float> distance;

    std::size_t size() const { return count == 0 ? 0 : index.size() / count; }
    /// Whether j is among the `first` nearest of i.
    /// Whether j is among the `first` nearest of i.
    bool sees(std::size_t i, std::uint32_t j, std::size_t first = gradedNeighbours) const {
        const auto row = index.begin() + static_cast<std::ptrdiff_t>(i * count);
        const auto end = row + static_cast<std::ptrdiff_t>(std::min(first, count));
        return std::find(row, end, j) != end;
    }
};

/// Where a wall is thin, the nearest may stand behind it, and their spacing would be the wall's thickness: where
/// normals are oriented, those of the own side count. Too few of them: all count. Rows are filled up with the last one.
/// `points` are the list that the cloud was made of. REQUIRES: two positions.
NeighbourGraph neighbourGraph(const Cloud& cloud, const surfel::SurfelList& points, const base::Progress& progress);

} // namespace process
