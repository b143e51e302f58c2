#include "core/tree/morton.h"

#include "core/base/morton.h"
#include "core/base/parallel.h"
#include "core/base/radix_sort.h"

#include <algorithm>
#include <bit>

namespace tree {

constexpr int bitsPerAxis = 10;
constexpr std::size_t grain = 1 << 16;

MortonGrid::MortonGrid(const base::Box3f& box) : m_origin(base::cast<double>(box.lo)) {
    const base::Vec3d size = base::cast<double>(box.hi) - m_origin;
    const double side = std::max({size.x, size.y, size.z});
    m_scale = side > 0 ? (1 << bitsPerAxis) / side : 0.0;
}

std::uint32_t MortonGrid::code(const base::Vec3f& p) const {
    const base::Vec3d cell = (base::cast<double>(p) - m_origin) * m_scale;
    const auto whole = [](double c) {
        return std::min(static_cast<std::uint32_t>(c), (std::uint32_t(1) << bitsPerAxis) - 1);
    };
    return static_cast<std::uint32_t>(base::mortonCode(whole(cell.x), whole(cell.y), whole(cell.z)));
}

/// `positionOf(i)` for i in [0, count).
template <class Fn>
static base::LargeArray<MortonKey> sortedBy(std::size_t count, const base::Box3f& box, const Fn& positionOf) {
    const MortonGrid grid(box);
    base::LargeArray<MortonKey> keys(count);
    base::parallelFor(count, grain, [&](std::size_t i) {
        keys[i] = MortonKey(grid.code(positionOf(i))) << 32 | static_cast<std::uint32_t>(i);
    });
    base::radixSort(keys, 3 * bitsPerAxis, codeOf);
    return keys;
}

base::LargeArray<MortonKey> sortedKeys(std::span<const surfel::Surfel> surfels, const base::Box3f& box) {
    return sortedBy(surfels.size(), box, [&](std::size_t i) { return surfels[i].position; });
}

base::LargeArray<MortonKey> sortedKeys(std::span<const base::Vec3f> positions, const base::Box3f& box) {
    return sortedBy(positions.size(), box, [&](std::size_t i) { return positions[i]; });
}

std::vector<std::uint32_t> sortedIndices(std::span<const base::Vec3f> positions, const base::Box3f& box) {
    const base::LargeArray<MortonKey> keys = sortedKeys(positions, box);
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
