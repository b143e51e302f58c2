// The clusters of a model, parted by cells: what vectorised sums over one cell run over (cells/README 4.1).
//
// A cluster of one cell is its own part, as the tree has it. Of others there is a copy for each cell, in which the
// surfels of the others have no weight. Parts also tell which of their surfels are beside creases.
#pragma once

#include "core/cells/labels.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cells {

/// Surfels of a part that are beside the crease with one other cell: a bit for each.
struct BesideCrease {
    std::uint32_t partner = 0;
    std::uint16_t all = 0, convex = 0;
    std::uint16_t faded = 0;     ///< those that are not quite sharp
    const float* fade = nullptr; ///< a cluster of them, with sharpness in place of the normal's x; null where all such
                                 ///< creases of both cells are sharp

    std::uint8_t sharpness(int lane) const {
        return fade ? static_cast<std::uint8_t>(std::lround(255 * fade[surfel::NormalX * surfel::clusterSize + lane]))
                    : 255;
    }
};

struct CellPart {
    const float* channels = nullptr; ///< as a block has them
    std::uint32_t cell = 0, face = 0;
    std::span<const BesideCrease> beside;
};

class CellParts {
  public:
    /// In parallel. The parts point into the tree's blocks.
    CellParts(const tree::SurfelTree& tree, const LabelLayout& labels);

    /// Of a cluster of the block of this number; by ascending cell.
    std::span<const CellPart> of(std::uint32_t block, int cluster) const {
        const Block& b = m_blocks[block];
        const auto c = static_cast<std::size_t>(cluster);
        return std::span(b.parts).subspan(b.first[c], static_cast<std::size_t>(b.first[c + 1] - b.first[c]));
    }

    /// Are there creases that are not quite sharp?
    bool fade() const { return m_fade; }
    /// Has the cell such a crease with one of another face?
    bool fadesToOtherFaces(std::uint32_t cell) const {
        return std::binary_search(m_fadingToOthers.begin(), m_fadingToOthers.end(), cell);
    }

  private:
    struct alignas(64) Channel {
        float lanes[surfel::clusterSize];
    };
    struct Block {
        std::uint16_t first[surfel::clustersPerBlock + 1] = {};
        std::vector<CellPart> parts;
        std::vector<BesideCrease> beside;
        std::vector<Channel> copies;
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>;

    std::vector<Pair> fadingPairs(const tree::SurfelTree& tree, const LabelLayout& labels) const;
    void findFadingToOthers(const std::vector<Pair>& fading);
    class Filling;

    std::vector<Block> m_blocks;
    bool m_fade = false;
    std::vector<std::uint32_t> m_fadingToOthers; ///< ascending
};

} // namespace cells
