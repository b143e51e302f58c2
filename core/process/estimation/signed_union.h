// Disjoint sets whose members carry a sign relative to each other (union-find with parity): joins along the edges of a
// spanning tree decide who is flipped against whom, without ever walking the tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace process {

class SignedUnion {
  public:
    explicit SignedUnion(std::size_t n) : m_link(n) {
        for (std::size_t i = 0; i < n; ++i)
            m_link[i] = i << 1;
    }

    struct Place {
        std::uint32_t root;
        bool flip; ///< against the root
    };

    Place find(std::uint32_t i) {
        std::uint64_t flip = 0;
        while (m_link[i] >> 1 != i) {
            const std::uint64_t parent = m_link[m_link[i] >> 1];
            m_link[i] = parent ^ (m_link[i] & 1); // halves the path: to the grandparent, with both signs
            flip ^= m_link[i] & 1;
            i = static_cast<std::uint32_t>(m_link[i] >> 1);
        }
        return {i, flip != 0};
    }

    /// False where both are joined already, whatever their signs.
    bool join(std::uint32_t a, std::uint32_t b, bool flip) {
        const Place p = find(a), q = find(b);
        if (p.root == q.root)
            return false;
        // The smaller number stays root: no second array, and Morton order keeps paths short.
        const std::uint32_t root = p.root < q.root ? p.root : q.root, other = p.root < q.root ? q.root : p.root;
        m_link[other] = std::uint64_t{root} << 1 | ((p.flip != q.flip) != flip ? 1u : 0u);
        return true;
    }

  private:
    std::vector<std::uint64_t> m_link; ///< parent << 1 | flip against it
};

} // namespace process
