#include "core/surface/evaluation/weights.h"

#include "core/base/clones.h"

namespace surface {

POINTCLAY_CLONES
static unsigned within(const float* cluster, const base::Vec3f& x, float* __restrict distanceSq) {
    const float *px = cluster, *py = px + surfel::clusterSize, *pz = py + surfel::clusterSize;
    const float* h = cluster + surfel::Support * surfel::clusterSize;
    const float cx = x.x, cy = x.y, cz = x.z;
    std::uint32_t in[surfel::clusterSize];
    for (int i = 0; i < surfel::clusterSize; ++i) {
        const float dx = px[i] - cx, dy = py[i] - cy, dz = pz[i] - cz;
        distanceSq[i] = dx * dx + dy * dy + dz * dz;
        in[i] = distanceSq[i] < h[i] * h[i] ? 1u << i : 0u;
    }
    unsigned out = 0;
    for (const std::uint32_t bit : in)
        out |= bit;
    return out;
}

POINTCLAY_CLONES
static unsigned withinShaped(const float* cluster, int shape, const base::Vec3f& x, float* __restrict distanceSq) {
    const float *px = cluster, *py = px + surfel::clusterSize, *pz = py + surfel::clusterSize;
    const float* h = cluster + surfel::Support * surfel::clusterSize;
    const float *bx = cluster + shape * surfel::clusterSize, *by = bx + surfel::clusterSize,
                *bz = by + surfel::clusterSize;
    const float cx = x.x, cy = x.y, cz = x.z;
    std::uint32_t in[surfel::clusterSize];
    for (int i = 0; i < surfel::clusterSize; ++i) {
        const float dx = px[i] - cx, dy = py[i] - cy, dz = pz[i] - cz;
        const float along = bx[i] * dx + by[i] * dy + bz[i] * dz;
        distanceSq[i] = dx * dx + dy * dy + dz * dz + along * along;
        in[i] = distanceSq[i] < h[i] * h[i] ? 1u << i : 0u;
    }
    unsigned out = 0;
    for (const std::uint32_t bit : in)
        out |= bit;
    return out;
}

unsigned withinSupport(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& x, float* distanceSq,
                       int shape) {
    const float* channels = block.channel(cluster, surfel::X);
    return shape > 0 ? withinShaped(channels, shape, x, distanceSq) : within(channels, x, distanceSq);
}

} // namespace surface
