// Places of surfels in lanes, cut into blocks and clusters by kd cuts (tree/README 2).
//
// Internal to the tree. A cut is a value along an axis, found among copies of the coordinates by quickselect (Hoare
// 1961) whose rounds are two passes in wide vectors; only then places move, once. The order (coordinate, source) is
// total, so that the cuts are the same on any machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tree {

class CutLanes {
  public:
    /// Room for `count` places, to be written.
    explicit CutLanes(std::size_t count);

    std::size_t size() const { return m_size; }
    float* axis(std::size_t k) { return m_lanes[k].get(); }
    std::uint32_t* sources() { return m_sources.get(); }

    /// Cuts all into so many blocks and returns their sizes, in order; the sources stand in the order of the blocks'
    /// slots then. Sources are unique. REQUIRES: as cutIntoBlocks.
    std::vector<std::uint32_t> cut(std::size_t blockCount);

    /// Behind every array, so that vectors may reach over its end.
    static constexpr std::size_t padding = 16;

  private:
    std::size_t m_size;
    std::unique_ptr<float[]> m_lanes[3];
    std::unique_ptr<std::uint32_t[]> m_sources;
};

} // namespace tree
