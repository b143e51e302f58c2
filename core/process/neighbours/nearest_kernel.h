// The k nearest of positions in cells, exactly: by float distance, ties by number (process/README 1.6).
//
// The positions of a cell are asked about together: what may be near any of them is gathered once, and one position's
// distances to it are taken in lanes. Where a cell's surroundings are too uneven for that, its positions walk the tree
// of boxes one by one. Both ways give the same answer, on any machine.
#pragma once

#include "core/process/neighbours/point_cells.h"

#include <vector>

namespace process {

/// Working memory of one thread.
struct NearestScratch {
    /// Clusters that are gathered about a cell at most.
    static constexpr std::size_t mostClusters = 512, mostPoints = mostClusters * PointCells::clusterSize;
    static constexpr std::size_t widest = 16;  ///< lanes
    static constexpr std::size_t recents = 16; ///< positions whose answers bound the next one's

    alignas(64) float x[mostPoints];
    alignas(64) float y[mostPoints];
    alignas(64) float z[mostPoints];
    alignas(64) float lo[3][mostClusters + widest];
    alignas(64) float hi[3][mostClusters + widest];
    std::uint32_t first[mostClusters]; ///< position of each cluster
    std::uint32_t near[mostClusters + widest];
    alignas(64) float distanceSq[mostPoints + widest];
    alignas(64) std::uint32_t index[mostPoints + widest];
    alignas(64) std::int32_t rank[mostPoints + widest];
    float sortedSq[mostPoints];
    std::uint32_t sortedIndex[mostPoints];
    alignas(64) float recent[3][recents];
    alignas(64) float reach[recents]; ///< distance of the farthest neighbour of each
};

/// Answers, `k` in a row, nearest first.
struct NearestRows {
    std::size_t cell = 0, first = 0, count = 0, k = 0; ///< of positions first to first + count - 1
    std::vector<std::uint32_t> index;
    std::vector<float> distanceSq;
};

/// All positions of a cell. REQUIRES: 1 <= k < positions.size().
void nearestOfCell(const PointCells& cells, std::span<const base::Vec3f> positions, std::size_t cell, std::size_t k,
                   NearestRows& out);

/// One position; `index` and `distanceSq` have room for k. REQUIRES: 1 <= k < positions.size().
void nearestOfOne(const PointCells& cells, std::span<const base::Vec3f> positions, std::uint32_t i, std::size_t k,
                  std::uint32_t* index, float* distanceSq);

/// The same from anywhere, with nothing left out. REQUIRES: 1 <= k <= positions.size().
void nearestFrom(const PointCells& cells, std::span<const base::Vec3f> positions, const base::Vec3f& x, std::size_t k,
                 std::uint32_t* index, float* distanceSq);

} // namespace process
