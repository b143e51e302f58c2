#include "core/sculpt/own_block.h"

#include "core/base/clones.h"
#include "core/process/estimation/spacing_sample.h"
#include "core/surfel/bounds_lanes.h"

#include <algorithm>
#include <array>
#include <limits>

namespace sculpt {

using surfel::clusterSize;

static constexpr int ring = 6;
static constexpr float nowhere = std::numeric_limits<float>::infinity();

/// What the surfels of one cluster have seen, in lanes.
struct Seen {
    alignas(64) float nearest[ring][clusterSize]; ///< squared distances of those that face alike, ascending
    alignas(64) float within[clusterSize];
};

/// Of one more surfel; `own` are the positions of the cluster, its normals behind them.
[[gnu::always_inline]] static inline void lookAt(const float* __restrict own, const float* __restrict radiusSq,
                                                 const base::Vec3f& p, const base::Vec3f& n, Seen& __restrict seen) {
    constexpr int c = clusterSize, normal = surfel::NormalX * c;
    for (int i = 0; i < c; ++i) {
        const float dx = p.x - own[i], dy = p.y - own[c + i], dz = p.z - own[2 * c + i];
        const float sq = dx * dx + dy * dy + dz * dz;
        const float facing = n.x * own[normal + i] + n.y * own[normal + c + i] + n.z * own[normal + 2 * c + i];
        seen.within[i] += sq <= radiusSq[i] ? 1.0f : 0.0f;
        float rest = facing >= 0 ? sq : nowhere;
        rest = sq > 0 ? rest : nowhere;
        for (int j = 0; j < ring; ++j) {
            const float least = seen.nearest[j][i];
            seen.nearest[j][i] = surfel::smaller(least, rest);
            rest = surfel::larger(least, rest);
        }
    }
}

POINTCLAY_CLONES
static void lookAtAll(const float* own, const float* radiusSq, const float* other, int others, Seen& seen) {
    constexpr int c = clusterSize, normal = surfel::NormalX * c;
    for (int k = 0; k < others; ++k)
        lookAt(own, radiusSq, {other[k], other[c + k], other[2 * c + k]},
               {other[normal + k], other[normal + c + k], other[normal + 2 * c + k]}, seen);
}

void lookWithin(const surfel::SurfelBlock& block, const float (&radiusSq)[surfel::blockCapacity], OwnBlock& out) {
    for (int cluster = 0; cluster < block.clusterCount(); ++cluster) {
        const int first = cluster * clusterSize;
        Seen seen;
        for (auto& row : seen.nearest)
            std::fill(std::begin(row), std::end(row), nowhere);
        std::fill(std::begin(seen.within), std::end(seen.within), 0.0f);
        for (int other = 0; other < block.clusterCount(); ++other)
            lookAtAll(block.channel(cluster, surfel::X), radiusSq + first, block.channel(other, surfel::X),
                      std::min(clusterSize, block.size() - other * clusterSize), seen);
        for (int i = 0; i < clusterSize; ++i) {
            std::array<float, ring> distancesSq;
            for (std::size_t j = 0; j < ring; ++j)
                distancesSq[j] = seen.nearest[j][i];
            out.ring[first + i] = process::spacingFromRing(distancesSq);
            out.within[first + i] = seen.within[i];
        }
    }
}

} // namespace sculpt
