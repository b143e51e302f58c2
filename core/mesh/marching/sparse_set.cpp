#include "core/mesh/marching/sparse_set.h"

#include "core/base/morton.h"

#include <algorithm>

namespace mesh {

namespace {

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
    static_assert(Lattice::extent / brickSide <= 1 << base::mortonBits);
    return base::mortonCode(static_cast<std::uint32_t>(p.x) >> 2, static_cast<std::uint32_t>(p.y) >> 2,
                            static_cast<std::uint32_t>(p.z) >> 2);
}

GridIndex lowestOf(std::uint64_t key) {
    const auto at = [key](int axis) { return static_cast<std::int32_t>(base::mortonCoordinate(key, axis) << 2); };
    return {at(0), at(1), at(2)};
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
    m_index.assign(static_cast<std::uint32_t>(m_bricks.size()), [this](std::uint32_t b) { return m_bricks[b].key; });
}

std::uint32_t SparseSet::find(std::uint64_t key) const {
    return m_index.find(key, [this](std::uint32_t b) { return m_bricks[b].key; });
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
