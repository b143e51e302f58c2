// Disjoint sets of numbered things (union-find; Tarjan 1975) with halved paths, plain and with a parity: whether two
// members of a set are alike or opposite.
//
//     DisjointSets pieces(vertices);     for each edge: pieces.join(a, b);     pieces.find(v): its piece
//     ParitySets signs(points);          for each edge: signs.relate(a, b, opposite)
//
// The smallest member represents a set. That needs no array of ranks, and paths stay short where things side by side
// have close numbers. `find` shortens paths, so it is not for several threads at once.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace base {

class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

    /// The representative of i's set.
    std::uint32_t find(std::uint32_t i) {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// False where both are of one set already.
    bool join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        m_parent[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

  private:
    std::vector<std::uint32_t> m_parent;
};

class ParitySets {
  public:
    /// REQUIRES: count < 2^31.
    explicit ParitySets(std::size_t count) : m_link(count) {
        for (std::size_t i = 0; i < count; ++i)
            m_link[i] = static_cast<std::uint32_t>(i) << 1;
    }

    struct Member {
        std::uint32_t root; ///< the representative of its set
        bool opposite;      ///< to the representative
    };
    Member find(std::uint32_t i) {
        std::uint32_t opposite = 0;
        while (m_link[i] >> 1 != i) {
            m_link[i] = m_link[m_link[i] >> 1] ^ (m_link[i] & 1); // to the grandparent, with both parities
            opposite ^= m_link[i] & 1;
            i = m_link[i] >> 1;
        }
        return {i, opposite != 0};
    }
    /// The same for any number of threads, while nobody changes anything: paths stay as they are.
    Member look(std::uint32_t i) const {
        std::uint32_t opposite = 0;
        while (m_link[i] >> 1 != i) {
            opposite ^= m_link[i] & 1;
            i = m_link[i] >> 1;
        }
        return {i, opposite != 0};
    }
    /// Shortens the path of i. Threads may do so at once, while nobody does anything else.
    void shorten(std::uint32_t i) {
        std::uint32_t root = i, opposite = 0;
        for (std::uint32_t link; (link = linkOf(root)) >> 1 != root; root = link >> 1)
            opposite ^= link & 1;
        std::atomic_ref(m_link[i]).store(root << 1 | opposite, std::memory_order_relaxed);
    }
    /// States that a and b are alike or opposite, and joins their sets. False where the contrary is known.
    bool relate(std::uint32_t a, std::uint32_t b, bool opposite) {
        const Member p = find(a), q = find(b);
        const bool between = (p.opposite != q.opposite) != opposite;
        if (p.root == q.root)
            return !between;
        m_link[std::max(p.root, q.root)] = std::min(p.root, q.root) << 1 | (between ? 1u : 0u);
        return true;
    }

    /// What `other` says of i. REQUIRES: to be called for all of a set that both have.
    void take(const ParitySets& other, std::uint32_t i) { m_link[i] = other.m_link[i]; }

  private:
    std::uint32_t linkOf(std::uint32_t i) { return std::atomic_ref(m_link[i]).load(std::memory_order_relaxed); }

    std::vector<std::uint32_t> m_link; ///< parent << 1 | opposite to it
};

} // namespace base
