#include "core/sculpt/tools/displace.h"

#include "core/sculpt/tools/mask_slope.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

/// Below 0 the deformation would turn inside out, which only a vertical rim asks for.
constexpr float leastStretch = 0.05f;

void carry(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int cluster, const base::Vec3f& d,
           const AmountLanes& by, bool footprints, surfel::MutableBlockPtr& changed) {
    const float* mask = block.channel(cluster, surfel::Mask);
    alignas(64) float amount[lanes];
    bool moves = false;
    for (std::size_t i = 0; i < lanes; ++i) {
        amount[i] = by.amount[i] * (1 - mask[i]);
        moves |= amount[i] != 0;
    }
    if (!moves)
        return;
    if (!changed)
        changed = block.clone();
    MaskSlopes slopes;
    maskSlopes(tree, block, cluster, slopes);
    float* x = changed->channel(cluster, surfel::X);
    float* y = changed->channel(cluster, surfel::Y);
    float* z = changed->channel(cluster, surfel::Z);
    float* nx = changed->channel(cluster, surfel::NormalX);
    float* ny = changed->channel(cluster, surfel::NormalY);
    float* nz = changed->channel(cluster, surfel::NormalZ);
    float* support = changed->channel(cluster, surfel::Support);
    for (std::size_t i = 0; i < lanes; ++i) {
        const float free = 1 - mask[i];
        const float gx = by.gx[i] * free - by.amount[i] * slopes.gx[i],
                    gy = by.gy[i] * free - by.amount[i] * slopes.gy[i],
                    gz = by.gz[i] * free - by.amount[i] * slopes.gz[i];
        const float stretch = std::max(leastStretch, 1 + gx * d.x + gy * d.y + gz * d.z);
        const float tilt = d.x * nx[i] + d.y * ny[i] + d.z * nz[i];
        const float mx = stretch * nx[i] - tilt * gx, my = stretch * ny[i] - tilt * gy,
                    mz = stretch * nz[i] - tilt * gz;
        const float length = std::sqrt(mx * mx + my * my + mz * mz);
        const bool turns = amount[i] != 0 && length > 1e-12f;
        const float scale = 1 / (turns ? length : 1.0f);
        nx[i] = turns ? mx * scale : nx[i], ny[i] = turns ? my * scale : ny[i], nz[i] = turns ? mz * scale : nz[i];
        support[i] = turns && footprints ? support[i] * std::sqrt(length) : support[i];
        x[i] = amount[i] != 0 ? x[i] + amount[i] * d.x : x[i];
        y[i] = amount[i] != 0 ? y[i] + amount[i] * d.y : y[i];
        z[i] = amount[i] != 0 ? z[i] + amount[i] * d.z : z[i];
    }
}

} // namespace sculpt
