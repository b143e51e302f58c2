#include "core/mesh/marching/sparse_set.h"

#include <algorithm>

namespace mesh {

namespace {

constexpr int bitsPerAxis = 20;

/// 20 bits with two free ones after each.
std::uint64_t spread(std::uint64_t v) {
    v = (v | v << 32) & 0x1f00000000ffffull;
    v = (v | v << 16) & 0x1f0000ff0000ffull;
    v = (v | v << 8) & 0x100f00f00f00f00full;
    v = (v | v << 4) & 0x10c30c30c30c30c3ull;
    v = (v | v << 2) & 0x1249249249249249ull;
    return v;
}

std::uint32_t gathered(std::uint64_t v) {
    v &= 0x1249249249249249ull;
    v = (v | v >> 2) & 0x10c30c30c30c30c3ull;
    v = (v | v >> 4) & 0x100f00f00f00f00full;
    v = (v | v >> 8) & 0x1f0000ff0000ffull;
    v = (v | v >> 16) & 0x1f00000000ffffull;
    v = (v | v >> 32) & 0x1fffff;
    return static_cast<std::uint32_t>(v);
}

std::uint64_t keyOf(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return spread(x) | spread(y) << 1 | spread(z) << 2;
}

std::size_t slotOf(std::uint64_t key, std::size_t mask) {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 20) & mask;
}

/// Bits of one brick moved up along an axis: what stays, and what the next brick gets.
struct Moved {
    std::uint64_t stays = 0, leaves = 0;
};
Moved movedUp(std::uint64_t mask, int axis) {
    constexpr std::uint64_t last[] = {0x8888888888888888ull, 0xf000f000f000f000ull, 0xffff000000000000ull};
    const int by = 1 << (2 * axis);
    return {(mask & ~last[axis]) << by, (mask & last[axis]) >> (3 * by)};
}

} // namespace

std::uint64_t brickKey(const GridIndex& p) {
    static_assert(Lattice::extent / brickSide <= 1 << bitsPerAxis);
    return keyOf(static_cast<std::uint32_t>(p.x) >> 2, static_cast<std::uint32_t>(p.y) >> 2,
                 static_cast<std::uint32_t>(p.z) >> 2);
}

GridIndex lowestOf(std::uint64_t key) {
    return {static_cast<std::int32_t>(gathered(key) << 2), static_cast<std::int32_t>(gathered(key >> 1) << 2),
            static_cast<std::int32_t>(gathered(key >> 2) << 2)};
}

void joinBits(std::vector<BrickBits>& bits) {
    std::sort(bits.begin(), bits.end(), [](const BrickBits& a, const BrickBits& b) { return a.key < b.key; });
    std::size_t count = 0;
    for (const BrickBits& each : bits)
        if (count > 0 && bits[count - 1].key == each.key)
            bits[count - 1].mask |= each.mask;
        else
            bits[count++] = each;
    bits.resize(count);
}

SparseSet::SparseSet(std::vector<BrickBits> bits) {
    joinBits(bits);
    m_bricks.reserve(bits.size());
    for (const BrickBits& each : bits) {
        m_bricks.push_back({each.key, each.mask, static_cast<std::uint32_t>(m_size)});
        m_size += static_cast<std::size_t>(std::popcount(each.mask));
    }
    m_table.assign(std::bit_ceil(2 * m_bricks.size() + 1), noRank);
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t b = 0; b < m_bricks.size(); ++b) {
        std::size_t slot = slotOf(m_bricks[b].key, mask);
        while (m_table[slot] != noRank)
            slot = (slot + 1) & mask;
        m_table[slot] = static_cast<std::uint32_t>(b);
    }
}

std::uint32_t SparseSet::find(std::uint64_t key) const {
    if (m_table.empty())
        return noRank;
    const std::size_t mask = m_table.size() - 1;
    for (std::size_t slot = slotOf(key, mask);; slot = (slot + 1) & mask)
        if (m_table[slot] == noRank || m_bricks[m_table[slot]].key == key)
            return m_table[slot];
}

std::uint32_t SparseSet::rank(const GridIndex& p) const {
    const std::uint32_t brick = find(brickKey(p));
    return brick == noRank ? noRank : rankIn(m_bricks[brick], bitOf(p.x & 3, p.y & 3, p.z & 3));
}

Neighbourhood::Neighbourhood(const SparseSet& set, std::uint32_t brick, bool below)
    : m_lowest(lowestOf(set.bricks()[brick].key)) {
    const int first = below ? -1 : 0;
    for (int z = first; z < 2; ++z)
        for (int y = first; y < 2; ++y)
            for (int x = first; x < 2; ++x) {
                const GridIndex at{m_lowest.x + x * brickSide, m_lowest.y + y * brickSide, m_lowest.z + z * brickSide};
                const std::uint32_t found = set.find(brickKey(at));
                m_bricks[std::size_t(x + 1 + 3 * (y + 1) + 9 * (z + 1))] =
                    found == noRank ? nullptr : &set.bricks()[found];
            }
}

SparseSet cornersOf(const SparseSet& cubes, const SparseSet& beside) {
    std::vector<BrickBits> bits;
    for (const SparseSet::Brick& brick : cubes.bricks())
        bits.push_back({brick.key, brick.mask});
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t count = bits.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Moved moved = movedUp(bits[i].mask, axis);
            bits[i].mask |= moved.stays;
            if (moved.leaves)
                bits.push_back({brickKey(lowestOf(bits[i].key).next(axis, brickSide)), moved.leaves});
        }
        joinBits(bits);
    }
    for (const SparseSet::Brick& brick : beside.bricks())
        bits.push_back({brick.key, brick.mask});
    return SparseSet(std::move(bits));
}

} // namespace mesh
