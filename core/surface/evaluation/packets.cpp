#include "core/surface/evaluation/packets.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/position_order.h"

#include <algorithm>

namespace surface {

namespace {

constexpr std::size_t packetSize = 32;   ///< positions at most
constexpr std::size_t packetsAtOnce = 8; ///< in preparation, so that their memory arrives while others are prepared
constexpr std::size_t positionsPerTask = 8 * packetSize;

/// Cuts packets off a list of positions, each as large as pays for what its positions share.
class PacketCutter {
  public:
    /// Prepares `source` for as many of the first of `order`, and returns how many. Packets mostly lie alike: where the
    /// last one was found at once, this may be twice as large.
    std::size_t cut(Source& source, std::span<const base::Vec3f> x, std::span<const std::uint32_t> order, float slack,
                    float distance) {
        m_count = std::min({packetSize, m_atOnce ? 2 * m_count : m_count, order.size()});
        m_atOnce = true;
        while (!source.announce(boxOf(x, order.first(m_count)), slack, m_count, distance)) {
            m_count = (m_count + 1) / 2;
            m_atOnce = false;
        }
        return m_count;
    }

  private:
    std::size_t m_count = packetSize;
    bool m_atOnce = true;
};

} // namespace

namespace detail {

void forEachGroup(const Surface& surface, std::span<const base::Vec3f> x, float slack, float distance,
                  const PacketFunction& fn) {
    if (x.empty())
        return;
    const std::vector<std::uint32_t> order = packetOrder(surface, x, packetSize);
    base::parallelChunks(x.size(), positionsPerTask, [&](std::size_t begin, std::size_t end, std::size_t) {
        std::vector<Source> sources;
        std::vector<Packet> packets;
        PacketCutter cutter;
        while (begin < end) {
            packets.clear();
            for (std::size_t k = 0; k < packetsAtOnce && begin < end; ++k) {
                if (k == sources.size())
                    sources.emplace_back(surface, std::max(slack, distance) > 0 ? Steps::Close : Steps::Apart);
                const std::span<const std::uint32_t> rest{order.data() + begin, end - begin};
                packets.push_back(rest.first(cutter.cut(sources[k], x, rest, slack, distance)));
                begin += packets.back().size();
            }
            for (std::size_t k = 0; k < packets.size(); ++k)
                sources[k].fetch();
            fn(std::span(sources).first(packets.size()), packets);
        }
    });
}

} // namespace detail

} // namespace surface
