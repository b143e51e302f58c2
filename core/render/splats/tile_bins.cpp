#include "core/render/splats/tile_bins.h"

#include "core/base/parallel.h"

#include <tuple>

namespace render {

/// Chunks keep a counter per tile; more of them than this would cost more than they help.
constexpr std::size_t maxChunks = 64, minGrain = 32;

static bool inOneTile(const ScreenBounds& b) {
    return b.left / tileWidth == b.right / tileWidth && b.top / tileHeight == b.bottom / tileHeight;
}

/// By depth, then by place, so that it does not matter where in the tree a block is: versions may differ in that.
static bool before(const BinEntry& a, const BinEntry& b) {
    if (a.nearest != b.nearest)
        return a.nearest < b.nearest;
    if (a.block == b.block)
        return false;
    const base::Vec3f p = a.block->box().lo, q = b.block->box().lo;
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

void TileBins::place(Chunk& chunk, const ScreenBounds& b, const BinEntry& entry) const {
    for (int row = b.top / tileHeight; row <= b.bottom / tileHeight; ++row)
        for (int column = b.left / tileWidth; column <= b.right / tileWidth; ++column) {
            const auto tile = static_cast<std::uint32_t>(row * m_columns + column);
            chunk.placed.push_back({tile, entry});
            ++chunk.next[tile];
        }
}

void TileBins::fill(std::span<const VisibleBlock> blocks, const ViewFrame& view, float reachOfSupport) {
    m_columns = (view.width + tileWidth - 1) / tileWidth;
    m_rows = (view.height + tileHeight - 1) / tileHeight;
    const auto tiles = static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows);
    const std::size_t grain = std::max(minGrain, base::chunkCount(blocks.size(), maxChunks));
    m_chunks.resize(base::chunkCount(blocks.size(), grain));

    base::parallelChunks(blocks.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t number) {
        Chunk& chunk = m_chunks[number];
        chunk.placed.clear();
        chunk.next.assign(tiles, 0);
        for (std::size_t i = begin; i < end; ++i) {
            const surfel::SurfelBlock* block = blocks[i].block;
            if (inOneTile(blocks[i].bounds)) {
                place(chunk, blocks[i].bounds, {block, blocks[i].bounds.nearest, block->clusterMask(), blocks[i].cuts});
                continue;
            }
            for (int c = 0; c < block->clusterCount(); ++c) {
                const surfel::ClusterBounds& cluster = block->bounds(c);
                const ScreenBounds bounds = screenBounds(view, cluster.box, reachOfSupport * cluster.maxSupport);
                if (bounds.visible)
                    place(chunk, bounds, {block, bounds.nearest, 1u << c, blocks[i].cuts});
            }
        }
    });

    m_begin.assign(tiles + 1, 0);
    std::size_t total = 0;
    for (std::size_t t = 0; t < tiles; ++t) {
        m_begin[t] = total;
        for (Chunk& chunk : m_chunks) {
            const std::uint32_t count = chunk.next[t];
            chunk.next[t] = static_cast<std::uint32_t>(total);
            total += count;
        }
    }
    m_begin[tiles] = total;
    m_entries.resize(total);
    base::parallelFor(m_chunks.size(), 1, [&](std::size_t number) {
        Chunk& chunk = m_chunks[number];
        for (const Placed& p : chunk.placed)
            m_entries[chunk.next[p.tile]++] = p.entry;
    });
    base::parallelFor(tiles, 16, [&](std::size_t t) {
        std::stable_sort(m_entries.begin() + static_cast<std::ptrdiff_t>(m_begin[t]),
                         m_entries.begin() + static_cast<std::ptrdiff_t>(m_begin[t + 1]), before);
    });
}

} // namespace render
