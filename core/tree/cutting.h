// Cutting surfels into blocks: kd cuts at multiples of the cluster size, so that all clusters but one are full.
//
// Internal to the tree. A `Pool` names surfels where they lie, in a list and in older blocks; cutting moves only their
// places and names (cut_lanes.h), and each block is then filled from its run of them. Sets are cut by (coordinate,
// source), and within a cluster surfels follow their source: results depend on nothing else.
#pragma once

#include "core/surfel/surfel_block.h"
#include "core/tree/cut_lanes.h"

#include <bitset>
#include <span>
#include <vector>

namespace tree {

/// Surfels per block that cuts aim at: 7 of 8 clusters, so that a few insertions fit (tree/README 1).
constexpr std::size_t blockTarget = 112;
/// Blocks below this size are merged with another.
constexpr std::size_t blockMinimum = 32;

struct CutItem {
    float position[3];
    std::uint32_t source; ///< see Pool
};

/// What is to be cut. Sources below `listBase` are places in `blocks`: 128 * index + slot; the others `list` entries.
struct Pool {
    static constexpr std::uint32_t listBase = 0x80000000u;

    const surfel::SurfelList* list = nullptr;       ///< not owned
    std::vector<const surfel::SurfelBlock*> blocks; ///< not owned
    std::vector<CutItem> items;

    void addBlock(const surfel::SurfelBlock& block, const std::bitset<surfel::blockCapacity>& removed);
    void addListed(std::uint32_t index);
};

/// Number of blocks for `count` surfels at the target size.
inline std::size_t blocksFor(std::size_t count) {
    return (count + blockTarget - 1) / blockTarget;
}

/// Cuts the items into `blockCount` blocks by kd cuts and fills them. REQUIRES: not empty; blockCount is at least
/// count / 128 and at most the number of clusters.
std::vector<surfel::BlockPtr> cutIntoBlocks(const Pool& pool, std::span<const CutItem> items, std::size_t blockCount,
                                            std::size_t extraWords);
/// The same for places in lanes, which are left in the order of the blocks' slots.
std::vector<surfel::BlockPtr> cutIntoBlocks(const Pool& pool, CutLanes& places, std::size_t blockCount,
                                            std::size_t extraWords);

} // namespace tree
