// Which clusters of surfels can touch which tile of the image: a counting sort in two parallel passes.
//
// A block that lies in one tile is entered once; a wider one is entered by its clusters' own bounds. Entries of a tile
// are in order of their nearest depth (ties by place), so that a tile can stop when everything left is hidden.
// The same at any thread count.
#pragma once

#include "core/render/splats/visible_blocks.h"

namespace render {

struct BinEntry {
    const surfel::SurfelBlock* block = nullptr;
    float nearest = 0;          ///< lower bound of the depth of its splats
    std::uint32_t clusters = 0; ///< bit per cluster
    const CutCodes* cuts = nullptr;
};

class TileBins {
  public:
    int columns() const { return m_columns; }
    int rows() const { return m_rows; }
    std::span<const BinEntry> tile(int number) const {
        const auto t = static_cast<std::size_t>(number);
        return {m_entries.data() + m_begin[t], m_begin[t + 1] - m_begin[t]};
    }

    void fill(std::span<const VisibleBlock> blocks, const ViewFrame& view, float reachOfSupport);

  private:
    struct Placed {
        std::uint32_t tile;
        BinEntry entry;
    };
    struct Chunk {
        std::vector<Placed> placed;
        std::vector<std::uint32_t> next; ///< per tile: first its count, then where its next entry goes
    };
    void place(Chunk& chunk, const ScreenBounds& bounds, const BinEntry& entry) const;

    int m_columns = 0, m_rows = 0;
    std::vector<Chunk> m_chunks;
    std::vector<std::size_t> m_begin; ///< per tile, and one past the end
    std::vector<BinEntry> m_entries;
};

} // namespace render
