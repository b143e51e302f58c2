// The k nearest surfels of up to 16 positions at once, best for positions that lie together: the answers of
// SurfelTree::nearest, to the bit.
//
//     NearestTogether around(tree, 14);
//     around.at(places);                    // up to 16 of them
//     around.of(i)                          // of places[i], nearest first
//     around.forEach(many, fn)              // as many as there are: fn(i, what is nearest to many[i])
//
// The positions are the lanes: one walk through the tree, nearest first, serves them all, and each surfel that it meets
// is put into 16 sorted lists of distances at once. Who the nearest are is told afterwards, by their distances. Where
// positions lie far apart the walk sees to each of them by itself. Used by one thread; keeps the tree alive.
#pragma once

#include "core/tree/surfel_tree.h"

#include <memory>
#include <span>

namespace tree {

/// Working memory of a walk. Internal.
struct NearestLanes {
    static constexpr std::size_t lanes = surfel::clusterSize;
    static constexpr std::size_t mostAsked = 32; ///< where k is larger a heap is cheaper
    static constexpr std::size_t mostRows = 512, mostListed = 48;
    struct Met {
        const surfel::SurfelBlock* block;
        std::uint32_t number;
        int slot;
    };

    alignas(64) float place[3][lanes];
    alignas(64) float best[mostAsked][lanes]; ///< the least squared distances so far, ascending
    alignas(64) float row[mostRows][lanes];   ///< squared distances of surfels that were near enough when they were met
    Met met[mostRows];
    std::size_t rows = 0;
    alignas(64) float listed[lanes][mostListed]; ///< of each place those that are near enough in the end
    std::uint32_t from[lanes][mostListed];       ///< their rows
    std::size_t count[lanes];                    ///< how many; more than mostListed: too many
    alignas(64) std::int32_t rank[mostListed];   ///< of the last that were ranked
};

class NearestTogether {
  public:
    static constexpr std::size_t most = NearestLanes::lanes;

    NearestTogether(SurfelTree tree, std::size_t k)
        : m_tree(std::move(tree)), m_k(k), m_lanes(std::make_unique_for_overwrite<NearestLanes>()) {}

    /// REQUIRES: at most `most` positions.
    void at(std::span<const base::Vec3f> x) { at(x, 0); }
    /// Until the next `at`. REQUIRES: i < x.size().
    std::span<const Neighbour> of(std::size_t i) const { return m_found[i]; }
    /// Any number of positions, in their order.
    template <class Fn>
    void forEach(std::span<const base::Vec3f> x, const Fn& fn) {
        for (std::size_t first = 0; first < x.size(); first += most) {
            const auto some = x.subspan(first, std::min(most, x.size() - first));
            at(some);
            for (std::size_t i = 0; i < some.size(); ++i)
                fn(first + i, of(i));
        }
    }

  private:
    void at(std::span<const base::Vec3f> x, std::size_t first);
    void answer(std::size_t lane, std::vector<Neighbour>& out);

    SurfelTree m_tree;
    std::size_t m_k;
    std::unique_ptr<NearestLanes> m_lanes;
    std::vector<Neighbour> m_found[most];
};

} // namespace tree
