#include "core/sculpt/tools/mask_slope.h"

#include "core/base/mat3.h"
#include "core/surface/evaluation/weights.h"

#include <algorithm>
#include <cmath>

namespace sculpt {

static base::Vec3f slopeAt(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot) {
    const base::Vec3f p = block.position(slot), n = block.normal(slot);
    const float h = block.support(slot), mask = block.mask(slot);
    base::Mat3f spread;
    base::Vec3f rise;
    tree.forBlocksInBall(p, h, [&](std::uint32_t, const surfel::SurfelBlock& near) {
        for (int k = 0; k < near.size(); ++k) {
            const base::Vec3f d = near.position(k) - p;
            const float l = length(d) / h;
            if (l >= 1 || dot(near.normal(k), n) < 0)
                continue;
            const float w = surface::wendlandC2(l);
            spread += outer(d, d) * w;
            rise += d * (w * (near.mask(k) - mask));
        }
    });
    const float ridge = 1e-3f * trace(spread);
    if (!(ridge > 0))
        return {};
    const base::Mat3d a = [&] {
        base::Mat3d out = base::Mat3d::identity() * double(ridge);
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c)
                out[r][c] += double(spread[r][c]);
        return out;
    }();
    return base::cast<float>(solvePositive(a, base::cast<double>(rise)));
}

/// Slots past the end have none.
static bool varies(const surfel::SurfelBlock& block, int cluster) {
    const float* mask = block.channel(cluster, surfel::Mask);
    int differ = 0;
    for (int i = 1; i < surfel::clusterSize; ++i)
        differ |= mask[i] != mask[0] ? 1 : 0;
    return differ != 0;
}

bool maskSlopes(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int cluster, MaskSlopes& out) {
    if (!varies(block, cluster))
        return false;
    const int first = cluster * surfel::clusterSize, end = std::min(block.size(), first + surfel::clusterSize);
    const float* mask = block.channel(cluster, surfel::Mask);
    const auto [least, most] = std::minmax_element(mask, mask + (end - first));
    if (*least == *most)
        return false;
    for (int slot = first; slot < end; ++slot) {
        const base::Vec3f g = slopeAt(tree, block, slot);
        out.gx[slot - first] = g.x, out.gy[slot - first] = g.y, out.gz[slot - first] = g.z;
    }
    return true;
}

} // namespace sculpt
