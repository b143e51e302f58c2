#include "core/surface/evaluation/position_order.h"

#include "core/surface/evaluation/source.h"
#include "core/tree/morton.h"

#include <algorithm>
#include <numeric>

namespace surface {

namespace {

/// Packets that are looked at before a batch is put in order.
constexpr std::size_t sampledPackets = 16;
/// Positions of one cell that are left as they are.
constexpr std::size_t fewInCell = 32;

std::vector<std::uint32_t> asTheyCome(std::size_t count) {
    std::vector<std::uint32_t> out(count);
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

bool scattered(const Surface& surface, std::span<const base::Vec3f> x, std::size_t packetSize) {
    const std::size_t packets = x.size() / packetSize, step = std::max<std::size_t>(1, packets / sampledPackets);
    Source source(surface, Steps::Apart);
    std::size_t sampled = 0, costly = 0;
    for (std::size_t packet = 0; packet < packets; packet += step, ++sampled) {
        base::Box3f box;
        for (const base::Vec3f& each : x.subspan(packet * packetSize, packetSize))
            box.extend(each);
        costly += source.announce(box, 0, packetSize) ? 0 : 1;
    }
    return 2 * costly > sampled;
}

/// Indices along a Morton curve. Outliers make a grid over all positions too coarse for the others: those of one cell
/// are ordered within their own box.
std::vector<std::uint32_t> ordered(std::span<const base::Vec3f> x) {
    base::Box3f box;
    for (const base::Vec3f& each : x)
        box.extend(each);
    const base::LargeArray<tree::MortonKey> keys = tree::sortedKeys(x, box);
    std::vector<std::uint32_t> out(keys.size());
    std::transform(keys.begin(), keys.end(), out.begin(), tree::indexOf);
    std::vector<base::Vec3f> own;
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
        for (++end; end < keys.size() && tree::codeOf(keys[end]) == tree::codeOf(keys[begin]);)
            ++end;
        const std::size_t count = end - begin;
        if (count <= fewInCell || count == keys.size()) // one cell for all: nothing to order by
            continue;
        const std::vector<std::uint32_t> cell(out.begin() + std::ptrdiff_t(begin), out.begin() + std::ptrdiff_t(end));
        own.clear();
        for (const std::uint32_t i : cell)
            own.push_back(x[i]);
        const std::vector<std::uint32_t> within = ordered(own);
        std::transform(within.begin(), within.end(), out.begin() + std::ptrdiff_t(begin),
                       [&](std::uint32_t i) { return cell[i]; });
    }
    return out;
}

} // namespace

base::Box3f boxOf(std::span<const base::Vec3f> x, std::span<const std::uint32_t> which) {
    base::Box3f out;
    for (const std::uint32_t i : which)
        out.extend(x[i]);
    return out;
}

std::vector<std::uint32_t> packetOrder(const Surface& surface, std::span<const base::Vec3f> x, std::size_t packetSize) {
    return x.size() > packetSize && scattered(surface, x, packetSize) ? ordered(x) : asTheyCome(x.size());
}

} // namespace surface
