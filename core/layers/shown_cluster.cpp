#include "core/layers/shown_cluster.h"

#include "core/base/clones.h"

#include <algorithm>
#include <cmath>

namespace layers {

using surfel::clusterSize;

/// Beyond this there is no smallest turn, and none is made.
constexpr float opposite = -0.999f;
/// An area vector shorter than this has no direction.
constexpr float leastAreaSq = 1e-6f;

/// Supports become no narrower than this part of the base's.
constexpr float leastWidth = 0.1f;

namespace {

/// What the layers so far have made of a cluster.
struct Climb {
    alignas(64) float up[3][clusterSize], normal[3][clusterSize], growth[clusterSize];
};

/// One layer more. `base`, `layer`: the first of their arrays. Branches are selections, so that lanes go together.
POINTCLAY_CLONES
void climb(const float* base, const float* layer, float strength, Climb& at) {
    const float *ax = base + 3 * clusterSize, *ay = base + 4 * clusterSize, *az = base + 5 * clusterSize,
                *h = base + 6 * clusterSize;
    const float *dx = layer, *dy = layer + clusterSize, *dz = layer + 2 * clusterSize;
    const float *ex = layer + 3 * clusterSize, *ey = layer + 4 * clusterSize, *ez = layer + 5 * clusterSize;
    const float *widens = layer + Widening * clusterSize, *mask = layer + OwnMask * clusterSize;
    const float grows = strength < 0 || strength > 1 ? 1.0f : 0.0f;
    for (int i = 0; i < clusterSize; ++i) {
        const float w = strength * (1 - mask[i]);
        const float any =
            std::abs(dx[i]) + std::abs(dy[i]) + std::abs(dz[i]) + std::abs(ex[i]) + std::abs(ey[i]) + std::abs(ez[i]);
        const bool some = any * w != 0;
        const float nx = at.normal[0][i], ny = at.normal[1][i], nz = at.normal[2][i];
        const float dot = ax[i] * nx + ay[i] * ny + az[i] * nz;
        const float far = std::sqrt(dx[i] * dx[i] + dy[i] * dy[i] + dz[i] * dz[i]), limit = leanLimit * h[i];
        const bool free = far > limit && dot >= opposite; // does not lean wholly
        const float g = free ? leaning(far, limit) : 1.0f;
        const float gx = ax[i] + g * (nx - ax[i]), gy = ay[i] + g * (ny - ay[i]), gz = az[i] + g * (nz - az[i]);
        const float unit = 1 / std::sqrt(free ? gx * gx + gy * gy + gz * gz : 1.0f);
        const float bx = free ? gx * unit : nx, by = free ? gy * unit : ny, bz = free ? gz * unit : nz;
        const float c = ax[i] * bx + ay[i] * by + az[i] * bz;
        const float turn = c < opposite ? 0.0f : 1.0f, f = turn / (c < opposite ? 1.0f : 1 + c);
        const float hx = ax[i] + bx, hy = ay[i] + by, hz = az[i] + bz;
        const float hd = (hx * dx[i] + hy * dy[i] + hz * dz[i]) * f;
        const float ad = 2 * turn * (ax[i] * dx[i] + ay[i] * dy[i] + az[i] * dz[i]);
        const float he = (hx * ex[i] + hy * ey[i] + hz * ez[i]) * f;
        const float ae = 2 * turn * (ax[i] * ex[i] + ay[i] * ey[i] + az[i] * ez[i]);
        at.up[0][i] += some ? w * (dx[i] - hx * hd + bx * ad) : 0.0f;
        at.up[1][i] += some ? w * (dy[i] - hy * hd + by * ad) : 0.0f;
        at.up[2][i] += some ? w * (dz[i] - hz * hd + bz * ad) : 0.0f;
        const float mx = nx + w * (ex[i] - hx * he + bx * ae), my = ny + w * (ey[i] - hy * he + by * ae),
                    mz = nz + w * (ez[i] - hz * he + bz * ae);
        const float areaSq = mx * mx + my * my + mz * mz;
        const bool turns = some && areaSq > leastAreaSq;
        const float one = 1 / std::sqrt(turns ? areaSq : 1.0f);
        at.normal[0][i] = turns ? mx * one : nx;
        at.normal[1][i] = turns ? my * one : ny;
        at.normal[2][i] = turns ? mz * one : nz;
        const float sx = ax[i] + w * ex[i], sy = ay[i] + w * ey[i], sz = az[i] + w * ez[i];
        const float tx = ax[i] + ex[i], ty = ay[i] + ey[i], tz = az[i] + ez[i];
        const float made = tx * tx + ty * ty + tz * tz, shown = sx * sx + sy * sy + sz * sz;
        const float ratio = shown / (made > 1 ? made : 1.0f);
        const bool wider = some && widens[i] == 0 && grows * ratio > 1;
        const float width = 1 + w * widens[i];
        at.growth[i] *= (width > leastWidth ? width : leastWidth) * std::sqrt(std::sqrt(wider ? ratio : 1.0f));
    }
}

} // namespace

std::vector<float> weightsOf(const Stack& stack) {
    std::vector<float> out;
    for (const Layer& each : stack.layers)
        out.push_back(each.weight());
    return out;
}

void show(const surfel::SurfelBlock& block, int cluster, const Channels& channels, std::span<const float> weights,
          ShownCluster& out) {
    const float* base = block.channel(cluster, channels.base);
    Climb at;
    for (int k = 0; k < 3; ++k) {
        std::fill_n(at.up[k], clusterSize, 0.0f);
        std::copy_n(base + (3 + k) * clusterSize, clusterSize, at.normal[k]);
    }
    std::fill_n(at.growth, clusterSize, 1.0f);
    for (std::size_t l = 0; l < weights.size(); ++l)
        if (weights[l] != 0)
            climb(base, block.channel(cluster, channels.layers[l]), weights[l], at);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < clusterSize; ++i) {
            out.position[k][i] = base[k * clusterSize + i] + at.up[k][i];
            out.normal[k][i] = at.normal[k][i];
        }
    for (int i = 0; i < clusterSize; ++i)
        out.support[i] = base[6 * clusterSize + i] * at.growth[i];
}

bool ShownCluster::agreesInPlace(const surfel::SurfelBlock& block, int cluster, int lane) const {
    bool same = true;
    for (int k = 0; k < 3; ++k)
        same = same && position[k][lane] == block.channel(cluster, surfel::X + k)[lane] &&
               normal[k][lane] == block.channel(cluster, surfel::NormalX + k)[lane];
    return same;
}

bool ShownCluster::agrees(const surfel::SurfelBlock& block, int cluster, int lane) const {
    return agreesInPlace(block, cluster, lane) && support[lane] == block.channel(cluster, surfel::Support)[lane];
}

void ShownCluster::put(surfel::SurfelBlock& block, int cluster, int lane) const {
    for (int k = 0; k < 3; ++k) {
        block.channel(cluster, surfel::X + k)[lane] = position[k][lane];
        block.channel(cluster, surfel::NormalX + k)[lane] = normal[k][lane];
    }
    block.channel(cluster, surfel::Support)[lane] = support[lane];
}

} // namespace layers
