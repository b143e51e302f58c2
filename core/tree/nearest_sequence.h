// The k nearest surfels of one position after another: the answers of SurfelTree::nearest, to the bit, for a fraction
// of their cost where each position is close to the one before.
//
//     NearestSequence around(tree, 14);
//     around.at(block.position(slot), near);      slot after slot
//
// Who stands e away from a position whose k-th neighbour is r away has k neighbours within r + e: the closest of the
// last 16 tells. Blocks that come so close are collected once for positions that follow each other; what is within r +
// e is picked out of their clusters and ranked. Where the blocks or the surfels would be too many, as beside outliers,
// the tree is asked as ever. Used by one thread; keeps the tree alive.
#pragma once

#include "core/tree/surfel_tree.h"

namespace tree {

class NearestSequence {
  public:
    NearestSequence(SurfelTree tree, std::size_t k) : m_tree(std::move(tree)), m_k(k) {}

    /// The k nearest of x, as SurfelTree::nearest has them.
    void at(const base::Vec3f& x, std::vector<Neighbour>& out);

  private:
    static constexpr int capacity = 128; ///< surfels picked for one position
    static constexpr int remembered = surfel::clusterSize;
    struct NearBlock {
        const surfel::SurfelBlock* block;
        std::uint32_t number;
    };
    /// Of what was picked, in tree order.
    struct Picked {
        alignas(64) float distanceSq[capacity];
        std::uint32_t block[capacity]; ///< into m_blocks
        std::int32_t slot[capacity];
        int count = 0;
    };

    /// The last positions, in lanes, and how far their k-th neighbours are; far from all where there is none.
    struct Known {
        alignas(64) float place[3][remembered];
        float farthest[remembered];
        int next = 0;

        Known();
        float bound(const base::Vec3f& x) const;
        void add(const base::Vec3f& x, float distance);
    };

    bool expect(const base::Vec3f& x, float radius);
    bool collect(const Node& node, std::uint32_t first, float radiusSq);
    bool pick(const base::Vec3f& x, float radiusSq);
    void rank(std::vector<Neighbour>& out) const;

    SurfelTree m_tree;
    std::size_t m_k;
    Known m_known;
    base::Vec3f m_centre;   ///< of the ball that m_blocks were collected for
    float m_collected = -1; ///< its radius; below 0: there is none
    std::vector<NearBlock> m_blocks;
    Picked m_picked;
};

} // namespace tree
