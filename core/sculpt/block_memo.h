// What is known of each surfel of some blocks: measured once, cluster after cluster, in parallel, and found by the
// block. Most blocks that a dab looks at are those that the dab before looked at.
//
// A value; const functions may run on any thread.
#pragma once

#include "core/base/parallel.h"
#include "core/tree/surfel_tree.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <unordered_map>
#include <vector>

namespace sculpt {

template <class T>
class BlockMemo {
  public:
    /// Measures what is missing of these blocks. newMeasure() gives what is called by one thread as measure(block,
    /// slots, out), for up to 16 slots of a block at once; it is called from many.
    template <class NewMeasure>
    void measure(std::span<const surfel::BlockPtr> blocks, const NewMeasure& newMeasure) {
        std::vector<Known> fresh;
        for (const surfel::BlockPtr& block : blocks)
            if (!m_known.contains(block.get()))
                fresh.push_back({block, std::vector<T>(static_cast<std::size_t>(block->size()))});
        base::parallelFor(fresh.size(), 1, [&](std::size_t i) {
            auto measure = newMeasure();
            std::array<int, surfel::clusterSize> slots;
            const std::size_t size = fresh[i].of.size();
            for (std::size_t first = 0; first < size; first += slots.size()) {
                std::iota(slots.begin(), slots.end(), static_cast<int>(first));
                const std::size_t count = std::min(slots.size(), size - first);
                measure(*fresh[i].block, std::span(slots).first(count), std::span(fresh[i].of).subspan(first, count));
            }
        });
        for (Known& each : fresh)
            m_known.emplace(each.block.get(), std::move(each));
    }
    /// Forgets all others.
    void keepOnly(std::span<const surfel::BlockPtr> blocks) {
        Map kept;
        for (const surfel::BlockPtr& block : blocks)
            if (const auto known = m_known.find(block.get()); known != m_known.end())
                kept.insert(m_known.extract(known));
        m_known = std::move(kept);
    }
    /// Null: not measured.
    const T* find(const surfel::SurfelBlock& block, int slot) const {
        const auto known = m_known.find(&block);
        return known == m_known.end() ? nullptr : &known->second.of[static_cast<std::size_t>(slot)];
    }

  private:
    struct Known {
        surfel::BlockPtr block; ///< held, so that no other has its address
        std::vector<T> of;
    };
    using Map = std::unordered_map<const surfel::SurfelBlock*, Known>;
    Map m_known;
};

/// Around what is resampled others are in the way, in spacings.
constexpr float inTheWay = 4;

/// Those that reach into a ball.
inline std::vector<surfel::BlockPtr> blocksAround(const tree::SurfelTree& tree, const base::Vec3f& centre,
                                                  float radius) {
    std::vector<surfel::BlockPtr> out;
    tree.forBlocksInBall(centre, radius,
                         [&](std::uint32_t number, const surfel::SurfelBlock&) { out.push_back(tree.block(number)); });
    return out;
}

} // namespace sculpt
