#include "core/surface/evaluation/packets.h"

#include "core/base/parallel.h"
#include "core/tree/morton.h"

#include <algorithm>
#include <numeric>

namespace surface {

namespace {

constexpr std::size_t packetSize = 32;   ///< positions at most
constexpr std::size_t packetsAtOnce = 8; ///< in preparation, so that their memory arrives while others are prepared
constexpr std::size_t positionsPerTask = 8 * packetSize;
/// In supports, the diagonal of a packet's box. In a larger one too many clusters serve too few positions.
constexpr float packetReach = 8;
/// In supports: where consecutive positions lie that far apart, on average over packets, they are put in order.
constexpr float scatteredReach = 32;

base::Box3f boxOf(std::span<const base::Vec3f> x) {
    base::Box3f out;
    for (const base::Vec3f& each : x)
        out.extend(each);
    return out;
}

/// Mean diagonal of the boxes of `packetSize` consecutive positions.
float meanDiagonal(std::span<const base::Vec3f> x) {
    double sum = 0;
    for (std::size_t begin = 0; begin < x.size(); begin += packetSize)
        sum += static_cast<double>(boxOf(x.subspan(begin, std::min(packetSize, x.size() - begin))).diagonal());
    return static_cast<float>(sum / static_cast<double>(base::chunkCount(x.size(), packetSize)));
}

/// Indices in an order in which neighbours are close.
std::vector<std::uint32_t> orderOf(std::span<const base::Vec3f> x, float support) {
    if (x.size() > packetSize && meanDiagonal(x) > scatteredReach * support)
        return tree::sortedIndices(x, boxOf(x));
    std::vector<std::uint32_t> out(x.size());
    std::iota(out.begin(), out.end(), 0u);
    return out;
}

/// How many of the first of `order` make a packet, and the box around them.
std::size_t cutPacket(std::span<const base::Vec3f> x, std::span<const std::uint32_t> order, float reach,
                      base::Box3f& box) {
    const std::size_t most = std::min(packetSize, order.size());
    box = {x[order[0]], x[order[0]]};
    std::size_t count = 1;
    for (; count < most; ++count) {
        base::Box3f larger = box;
        larger.extend(x[order[count]]);
        if (!(lengthSq(larger.hi - larger.lo) <= reach * reach))
            break;
        box = larger;
    }
    return count;
}

} // namespace

namespace detail {

void forEachPacket(const Surface& surface, std::span<const base::Vec3f> x, float slack,
                   const std::function<void(Source&, std::span<const std::uint32_t>)>& fn) {
    if (x.empty())
        return;
    const float support = surface.supportScale() * surface.tree().maxSupport();
    const std::vector<std::uint32_t> order = orderOf(x, support);
    base::parallelChunks(x.size(), positionsPerTask, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<Source> sources;
        std::vector<std::span<const std::uint32_t>> packets;
        while (begin < end) {
            packets.clear();
            for (std::size_t k = 0; k < packetsAtOnce && begin < end; ++k) {
                base::Box3f box;
                const std::span<const std::uint32_t> rest{order.data() + begin, end - begin};
                packets.push_back(rest.first(cutPacket(x, rest, packetReach * support, box)));
                begin += packets.back().size();
                if (k == sources.size())
                    sources.emplace_back(surface, slack > 0 ? Steps::Close : Steps::Apart);
                sources[k].announce(box.inflated(slack * support));
            }
            for (std::size_t k = 0; k < packets.size(); ++k)
                sources[k].fetch();
            for (std::size_t k = 0; k < packets.size(); ++k)
                fn(sources[k], packets[k]);
        }
    });
}

} // namespace detail

} // namespace surface
