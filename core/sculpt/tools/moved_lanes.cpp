#include "core/sculpt/tools/moved_lanes.h"

#include "core/base/clones.h"

#include <cmath>

namespace sculpt {

/// Lengths of the turned normals, 1 where they stay, and the normals.
POINTCLAY_CLONES
static void turn(const MovedLanes& by, float* __restrict nx, float* __restrict ny, float* __restrict nz,
                 float* __restrict stretch) {
    for (int i = 0; i < surfel::clusterSize; ++i) {
        const float mx = by.m[0][i], my = by.m[1][i], mz = by.m[2][i];
        const float sq = mx * mx + my * my + mz * mz, turns = sq > 1e-24f ? by.turns[i] : 0.0f;
        const float length = std::sqrt(turns != 0 ? sq : 1.0f), scale = 1 / length;
        const float turnedX = mx * scale, turnedY = my * scale, turnedZ = mz * scale;
        nx[i] = turns != 0 ? turnedX : nx[i];
        ny[i] = turns != 0 ? turnedY : ny[i];
        nz[i] = turns != 0 ? turnedZ : nz[i];
        stretch[i] = length;
    }
}

void move(surfel::SurfelBlock& block, int cluster, const MovedLanes& by, bool footprints) {
    alignas(64) float stretch[surfel::clusterSize];
    turn(by, block.channel(cluster, surfel::NormalX), block.channel(cluster, surfel::NormalY),
         block.channel(cluster, surfel::NormalZ), stretch);
    for (int k = 0; k < 3; ++k) {
        float* p = block.channel(cluster, surfel::X + k);
        for (int i = 0; i < surfel::clusterSize; ++i)
            p[i] += by.d[k][i];
    }
    float* support = block.channel(cluster, surfel::Support);
    for (int i = 0; footprints && i < surfel::clusterSize; ++i)
        support[i] *= std::sqrt(stretch[i]);
}

} // namespace sculpt
