#include "core/surface/packets.h"

#include "core/base/parallel.h"
#include "core/tree/morton.h"

#include <algorithm>
#include <numeric>

namespace surface {

namespace {

constexpr std::size_t packetSize = 32;
constexpr std::size_t packetsPerTask = 8;
/// In supports: packets whose boxes are larger share too little; where they are 4 times that, the batch is scattered.
constexpr float coherentReach = 6;

base::Box3f boxOf(std::span<const base::Vec3f> x) {
    base::Box3f out;
    for (const base::Vec3f& each : x)
        out.extend(each);
    return out;
}

/// Mean diagonal of the packets' boxes.
float meanDiagonal(std::span<const base::Vec3f> x) {
    double sum = 0;
    for (std::size_t begin = 0; begin < x.size(); begin += packetSize)
        sum += static_cast<double>(boxOf(x.subspan(begin, std::min(packetSize, x.size() - begin))).diagonal());
    return static_cast<float>(sum / static_cast<double>(base::chunkCount(x.size(), packetSize)));
}

/// Indices along a Morton curve through the box of all positions (10 bits an axis).
std::vector<std::uint32_t> mortonOrder(std::span<const base::Vec3f> x) {
    const tree::MortonGrid grid(boxOf(x));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> keys(x.size());
    base::parallelFor(x.size(), 4096, [&](std::size_t i) {
        keys[i] = {grid.code(x[i]), static_cast<std::uint32_t>(i)};
    });
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> out(x.size());
    std::transform(keys.begin(), keys.end(), out.begin(), [](const auto& key) { return key.second; });
    return out;
}

} // namespace

void forPackets(const Surface& surface, std::span<const base::Vec3f> x, float slack,
                const std::function<void(Source&, std::size_t)>& fn) {
    if (x.empty())
        return;
    const float support = surface.supportScale() * surface.tree().maxSupport();
    std::vector<std::uint32_t> order;
    if (x.size() > packetSize && meanDiagonal(x) > 4 * coherentReach * support)
        order = mortonOrder(x);
    const auto index = [&](std::size_t i) { return order.empty() ? i : order[i]; };
    base::parallelChunks(x.size(), packetSize * packetsPerTask, [&](std::size_t begin, std::size_t end, std::size_t) {
        Source source(surface, slack > 0 ? Steps::Close : Steps::Apart);
        for (std::size_t first = begin; first < end; first += packetSize) {
            const std::size_t last = std::min(end, first + packetSize);
            base::Box3f box;
            for (std::size_t i = first; i < last; ++i)
                box.extend(x[index(i)]);
            if (box.diagonal() <= (slack > 0 ? 2 : 1) * coherentReach * support)
                source.expect(box.inflated(slack * support));
            for (std::size_t i = first; i < last; ++i)
                fn(source, index(i));
        }
    });
}

} // namespace surface
