// Disjoint classes of numbered things (union-find with halved paths), and the same with a parity: whether two things of
// a class are alike or opposite.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace mesh {

class Classes {
  public:
    explicit Classes(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

    /// The representative: the smallest member.
    std::uint32_t of(std::uint32_t i) {
        while (m_parent[i] != i)
            i = m_parent[i] = m_parent[m_parent[i]];
        return i;
    }
    /// False where they were one already.
    bool unite(std::uint32_t a, std::uint32_t b) {
        a = of(a), b = of(b);
        if (a == b)
            return false;
        m_parent[std::max(a, b)] = std::min(a, b);
        return true;
    }

  private:
    std::vector<std::uint32_t> m_parent;
};

class ParityClasses {
  public:
    explicit ParityClasses(std::size_t count) : m_parent(count), m_size(count, 1), m_opposite(count, false) {
        std::iota(m_parent.begin(), m_parent.end(), 0u);
    }

    /// The representative and whether `i` is opposite to it.
    std::pair<std::uint32_t, bool> of(std::uint32_t i) const {
        bool opposite = false;
        for (; m_parent[i] != i; i = m_parent[i])
            opposite ^= m_opposite[i];
        return {i, opposite};
    }
    /// Says that a and b are alike or opposite. False where it is known to be otherwise.
    bool relate(std::uint32_t a, std::uint32_t b, bool opposite) {
        auto [rootA, oppositeA] = of(a);
        auto [rootB, oppositeB] = of(b);
        const bool between = opposite ^ oppositeA ^ oppositeB;
        if (rootA == rootB)
            return !between;
        if (m_size[rootA] < m_size[rootB] || (m_size[rootA] == m_size[rootB] && rootB < rootA))
            std::swap(rootA, rootB);
        m_parent[rootB] = rootA;
        m_size[rootA] += m_size[rootB];
        m_opposite[rootB] = between;
        return true;
    }

  private:
    std::vector<std::uint32_t> m_parent, m_size;
    std::vector<bool> m_opposite; ///< to the parent
};

} // namespace mesh
