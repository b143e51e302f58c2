// A set of grid indices as bricks of 4 x 4 x 4, each one 64-bit word: memory follows the number of bricks, and every
// member has a number, its rank in the order of bricks.
//
//     SparseSet set(std::move(bits));                 from words gathered anywhere, in any order
//     Neighbourhood around(set, b);                   brick b and the seven above it
//     around.rank(place)                              of a place in them
//
// Bricks follow a Morton curve, so that neighbours in the order are neighbours in space.
#pragma once

#include "core/base/key_index.h"
#include "core/mesh/marching/lattice.h"

#include <array>
#include <bit>
#include <vector>

namespace mesh {

constexpr int brickSide = 4;
constexpr std::uint32_t noRank = base::KeyIndex::none;

/// Some members of one brick. Keys are Morton codes of brick coordinates.
struct BrickBits {
    std::uint64_t key = 0, mask = 0;
};

std::uint64_t brickKey(const GridIndex& p);
/// The lowest index of a brick.
GridIndex lowestOf(std::uint64_t key);
constexpr int bitOf(int x, int y, int z) {
    return x | y << 2 | z << 4;
}
inline BrickBits bitsOf(const GridIndex& p) {
    return {brickKey(p), std::uint64_t(1) << bitOf(p.x & 3, p.y & 3, p.z & 3)};
}
/// Sorts by key and joins the words of one brick.
void joinBits(std::vector<BrickBits>& bits);

class SparseSet {
  public:
    struct Brick {
        std::uint64_t key = 0, mask = 0;
        std::uint32_t first = 0; ///< rank of the lowest member
    };

    SparseSet() = default;
    explicit SparseSet(std::vector<BrickBits> bits);

    std::size_t size() const { return m_size; }
    const std::vector<Brick>& bricks() const { return m_bricks; }
    /// Number of the brick, or noRank.
    std::uint32_t find(std::uint64_t key) const;
    std::uint32_t rank(const GridIndex& p) const;
    bool contains(const GridIndex& p) const { return rank(p) != noRank; }
    /// Calls fn(index, rank) for all members of a brick.
    template <class Fn>
    void forMembers(std::uint32_t brick, const Fn& fn) const {
        const GridIndex lowest = lowestOf(m_bricks[brick].key);
        std::uint32_t rank = m_bricks[brick].first;
        for (std::uint64_t rest = m_bricks[brick].mask; rest; rest &= rest - 1) {
            const int bit = std::countr_zero(rest);
            fn(GridIndex{lowest.x + (bit & 3), lowest.y + (bit >> 2 & 3), lowest.z + (bit >> 4)}, rank++);
        }
    }

  private:
    std::vector<Brick> m_bricks;
    base::KeyIndex m_index; ///< of the bricks
    std::size_t m_size = 0;
};

/// Number of bits, without the call that std::popcount is on processors that must not be expected to count.
constexpr std::uint32_t countBits(std::uint64_t v) {
    v -= v >> 1 & 0x5555555555555555ull;
    v = (v & 0x3333333333333333ull) + (v >> 2 & 0x3333333333333333ull);
    v = (v + (v >> 4)) & 0x0f0f0f0f0f0f0f0full;
    return static_cast<std::uint32_t>((v * 0x0101010101010101ull) >> 56);
}

inline std::uint32_t rankIn(const SparseSet::Brick& brick, int bit) {
    if (!(brick.mask >> bit & 1))
        return noRank;
    return brick.first + countBits(brick.mask & ((std::uint64_t(1) << bit) - 1));
}

/// A brick and those around it: ranks without looking bricks up again and again.
class Neighbourhood {
  public:
    /// Below the brick there are neighbours too if `below`.
    Neighbourhood(const SparseSet& set, std::uint32_t brick, bool below = false);

    const GridIndex& lowest() const { return m_lowest; }
    /// REQUIRES: less than a brick away from the brick, not below it unless asked for.
    std::uint32_t rank(const GridIndex& p) const {
        const int x = p.x - m_lowest.x + brickSide, y = p.y - m_lowest.y + brickSide, z = p.z - m_lowest.z + brickSide;
        const SparseSet::Brick* brick = m_bricks[std::size_t((x >> 2) + 3 * (y >> 2) + 9 * (z >> 2))];
        return brick ? rankIn(*brick, bitOf(x & 3, y & 3, z & 3)) : noRank;
    }

  private:
    GridIndex m_lowest;
    std::array<const SparseSet::Brick*, 27> m_bricks{};
};

/// The corners of a set of cubes.
SparseSet cornersOf(const SparseSet& cubes, const SparseSet& beside = {});

} // namespace mesh
