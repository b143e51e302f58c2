#include "core/sculpt/tools/displace.h"

#include "core/base/clones.h"
#include "core/sculpt/tools/mask_slope.h"
#include "core/sculpt/tools/moved_lanes.h"

namespace sculpt {

/// Below 0 the deformation would turn inside out, which only a vertical rim asks for.
constexpr float leastStretch = 0.05f;

/// 16 lanes of carry: D = amount (1 - mask) d and cof(F) n. Returns whether any lane moves.
POINTCLAY_CLONES
static bool carryLanes(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& d, const AmountLanes& by,
                       const MaskSlopes& slopes, MovedLanes& out) {
    const float* mask = block.channel(cluster, surfel::Mask);
    const float* nx = block.channel(cluster, surfel::NormalX);
    const float* ny = block.channel(cluster, surfel::NormalY);
    const float* nz = block.channel(cluster, surfel::NormalZ);
    const float dx = d.x, dy = d.y, dz = d.z;
    int moves = 0;
#pragma GCC ivdep
    for (std::size_t i = 0; i < lanes; ++i) {
        const float free = 1 - mask[i], amount = by.amount[i] * free;
        const float gx = by.gx[i] * free - by.amount[i] * slopes.gx[i],
                    gy = by.gy[i] * free - by.amount[i] * slopes.gy[i],
                    gz = by.gz[i] * free - by.amount[i] * slopes.gz[i];
        const float asked = 1 + gx * dx + gy * dy + gz * dz, stretch = asked < leastStretch ? leastStretch : asked;
        const float tilt = dx * nx[i] + dy * ny[i] + dz * nz[i];
        out.m[0][i] = stretch * nx[i] - tilt * gx;
        out.m[1][i] = stretch * ny[i] - tilt * gy;
        out.m[2][i] = stretch * nz[i] - tilt * gz;
        out.d[0][i] = amount * dx, out.d[1][i] = amount * dy, out.d[2][i] = amount * dz;
        out.turns[i] = amount != 0 ? 1.0f : 0.0f;
        moves |= amount != 0 ? 1 : 0;
    }
    return moves != 0;
}

void carry(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int cluster, const base::Vec3f& d,
           const AmountLanes& by, bool footprints, surfel::MutableBlockPtr& changed) {
    MaskSlopes slopes;
    MovedLanes moved;
    maskSlopes(tree, block, cluster, slopes);
    if (!carryLanes(block, cluster, d, by, slopes, moved))
        return;
    if (!changed)
        changed = block.clone();
    move(*changed, cluster, moved, footprints);
    const float* mask = block.channel(cluster, surfel::Mask);
    moveShapes(*changed, block, cluster, surfel::shapeChannel(*tree.layout()), moved, footprints, [&](int lane) {
        const auto i = static_cast<std::size_t>(lane);
        const base::Vec3f g = base::Vec3f{by.gx[i], by.gy[i], by.gz[i]} * (1 - mask[i]) -
                              base::Vec3f{slopes.gx[i], slopes.gy[i], slopes.gz[i]} * by.amount[i];
        return base::Mat3d::identity() + outer(base::cast<double>(d), base::cast<double>(g));
    });
}

} // namespace sculpt
