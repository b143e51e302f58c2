#include "core/tree/morton.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace tree {

constexpr int bitsPerAxis = 10;
constexpr int digitBits = 10; ///< three passes cover the 30 bits
constexpr std::size_t digits = std::size_t(1) << digitBits;
constexpr std::size_t grain = 1 << 16;

MortonGrid::MortonGrid(const base::Box3f& box) : m_origin(base::cast<double>(box.lo)) {
    const base::Vec3d size = base::cast<double>(box.hi) - m_origin;
    const double side = std::max({size.x, size.y, size.z});
    m_scale = side > 0 ? (1 << bitsPerAxis) / side : 0.0;
}

/// Spreads 10 bits to every third place.
static std::uint32_t spread(std::uint32_t v) {
    v = (v | v << 16) & 0x030000ffu;
    v = (v | v << 8) & 0x0300f00fu;
    v = (v | v << 4) & 0x030c30c3u;
    return (v | v << 2) & 0x09249249u;
}

std::uint32_t MortonGrid::code(const base::Vec3f& p) const {
    const base::Vec3d cell = (base::cast<double>(p) - m_origin) * m_scale;
    const auto whole = [](double c) {
        return std::min(static_cast<std::uint32_t>(c), (std::uint32_t(1) << bitsPerAxis) - 1);
    };
    return spread(whole(cell.x)) | spread(whole(cell.y)) << 1 | spread(whole(cell.z)) << 2;
}

/// One stable pass by the digit at `shift`: each chunk counts, offsets are summed digit by digit and chunk by chunk.
static void radixPass(const std::vector<MortonKey>& in, std::vector<MortonKey>& out, int shift) {
    using Counts = std::array<std::uint32_t, digits>;
    const auto digit = [shift](MortonKey key) { return key >> shift & (digits - 1); };
    std::vector<Counts> offsets(base::chunkCount(in.size(), grain));
    base::parallelChunks(in.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        offsets[chunk].fill(0);
        for (std::size_t i = begin; i < end; ++i)
            ++offsets[chunk][digit(in[i])];
    });
    std::uint32_t sum = 0;
    for (std::size_t d = 0; d < digits; ++d)
        for (Counts& counts : offsets)
            sum += std::exchange(counts[d], sum);
    base::parallelChunks(in.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i)
            out[offsets[chunk][digit(in[i])]++] = in[i];
    });
}

/// `positionOf(i)` for i in [0, count).
template <class Fn>
static std::vector<MortonKey> sortedBy(std::size_t count, const base::Box3f& box, const Fn& positionOf) {
    const MortonGrid grid(box);
    std::vector<MortonKey> keys(count), other(count);
    base::parallelFor(count, grain, [&](std::size_t i) {
        keys[i] = MortonKey(grid.code(positionOf(i))) << 32 | static_cast<std::uint32_t>(i);
    });
    for (int pass = 0; pass < 3; ++pass) {
        radixPass(keys, other, 32 + pass * digitBits);
        keys.swap(other);
    }
    return keys;
}

std::vector<MortonKey> sortedKeys(std::span<const surfel::Surfel> surfels, const base::Box3f& box) {
    return sortedBy(surfels.size(), box, [&](std::size_t i) { return surfels[i].position; });
}

std::vector<MortonKey> sortedKeys(std::span<const base::Vec3f> positions, const base::Box3f& box) {
    return sortedBy(positions.size(), box, [&](std::size_t i) { return positions[i]; });
}

std::vector<std::uint32_t> sortedIndices(std::span<const base::Vec3f> positions, const base::Box3f& box) {
    const std::vector<MortonKey> keys = sortedKeys(positions, box);
    std::vector<std::uint32_t> out(keys.size());
    std::transform(keys.begin(), keys.end(), out.begin(), indexOf);
    return out;
}

/// Where to cut: the change of the highest bit within the middle 40 %, the one nearest to the middle among equals.
static std::size_t bestCut(std::span<const MortonKey> keys) {
    const std::size_t middle = keys.size() / 2, reach = keys.size() / 5;
    std::size_t best = middle;
    std::uint32_t highest = 0;
    for (std::size_t i = middle - reach; i <= middle + reach; ++i) {
        const int change = std::bit_width(codeOf(keys[i - 1]) ^ codeOf(keys[i]));
        const auto distance = [middle](std::size_t at) { return at > middle ? at - middle : middle - at; };
        const auto height = static_cast<std::uint32_t>(change);
        if (height > highest || (height == highest && distance(i) < distance(best)))
            best = i, highest = height;
    }
    return best;
}

static void cutRun(std::span<const MortonKey> keys, std::size_t first, std::size_t longest,
                   std::vector<std::size_t>& ends) {
    if (keys.size() <= longest) {
        ends.push_back(first + keys.size());
        return;
    }
    const std::size_t at = bestCut(keys);
    cutRun(keys.first(at), first, longest, ends);
    cutRun(keys.subspan(at), first + at, longest, ends);
}

std::vector<std::size_t> cutRuns(std::span<const MortonKey> keys, std::size_t longest) {
    std::vector<std::size_t> ends;
    cutRun(keys, 0, longest, ends);
    return ends;
}

} // namespace tree
