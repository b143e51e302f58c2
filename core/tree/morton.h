// Order along a Morton curve of 10 bits per axis (Morton 1966), by a stable parallel radix sort.
//
// Internal to the core. Same order at any thread count.
#pragma once

#include "core/base/box.h"
#include "core/base/large_array.h"
#include "core/surfel/surfel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tree {

/// Code in the high word, index of the surfel or position in the low word.
using MortonKey = std::uint64_t;

constexpr std::uint32_t codeOf(MortonKey key) {
    return static_cast<std::uint32_t>(key >> 32);
}
constexpr std::uint32_t indexOf(MortonKey key) {
    return static_cast<std::uint32_t>(key);
}

/// Interleaves the bits of a position in a grid of 1024 cubes to a side laid over `box`. REQUIRES: box contains p.
class MortonGrid {
  public:
    explicit MortonGrid(const base::Box3f& box);
    std::uint32_t code(const base::Vec3f& p) const;

  private:
    base::Vec3d m_origin;
    double m_scale = 0;
};

/// Keys of all surfels or positions, ascending. REQUIRES: `box` contains all positions.
base::LargeArray<MortonKey> sortedKeys(std::span<const surfel::Surfel> surfels, const base::Box3f& box);
base::LargeArray<MortonKey> sortedKeys(std::span<const base::Vec3f> positions, const base::Box3f& box);
/// Indices of the positions in that order.
std::vector<std::uint32_t> sortedIndices(std::span<const base::Vec3f> positions, const base::Box3f& box);

/// Cuts sorted keys into runs of at most `longest`: always where the highest bit of the code changes within the middle
/// 40 %, so that no run straddles a far jump of the curve. Returns the ends of the runs.
std::vector<std::size_t> cutRuns(std::span<const MortonKey> keys, std::size_t longest);

} // namespace tree
