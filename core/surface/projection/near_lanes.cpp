#include "core/surface/projection/near_lanes.h"

#include <algorithm>
#include <cmath>

namespace surface {

using Quad [[gnu::vector_size(16), gnu::may_alias]] = float;
constexpr float wellAboveZero = 1e-12f; ///< its square is a number, too

/// Fills a lane up with surfels far beyond their own supports from wherever its position may come to.
static void pad(float x, float y, float z, float reach, float (&rows)[NearLanes::rows][NearLanes::stride],
                std::size_t from, std::size_t to) {
    const float away = 8 * std::max({reach, std::abs(x), wellAboveZero});
    const float one[NearLanes::rows] = {x + away, y, z, 0, 0, 0, away / 4, 4 / away};
    for (std::size_t row = 0; row < NearLanes::rows; ++row)
        std::fill(rows[row] + from, rows[row] + to, one[row]);
}

/// Four surfels of four lanes, `step` floats apart there and `apart` here, and again to the groups of lanes after
/// these, `groups` in all.
static void turn(const float* from, std::size_t step, float* to, std::size_t apart, std::size_t groups) {
    const auto load = [&](std::size_t i) { return *reinterpret_cast<const Quad*>(from + i * step); };
    const auto store = [&](std::size_t i, Quad v) {
        for (std::size_t group = 0; group < groups; ++group)
            *reinterpret_cast<Quad*>(to + i * apart + 4 * group) = v;
    };
    const Quad a = load(0), b = load(1), c = load(2), d = load(3);
    const Quad ab = __builtin_shufflevector(a, b, 0, 4, 1, 5), cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    const Quad abUp = __builtin_shufflevector(a, b, 2, 6, 3, 7), cdUp = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    store(0, __builtin_shufflevector(ab, cd, 0, 1, 4, 5));
    store(1, __builtin_shufflevector(ab, cd, 2, 3, 6, 7));
    store(2, __builtin_shufflevector(abUp, cdUp, 0, 1, 4, 5));
    store(3, __builtin_shufflevector(abUp, cdUp, 2, 3, 6, 7));
}

void turnNear(const float (&around)[3][NearLanes::lanes], const float (&reach)[NearLanes::lanes], std::size_t used,
              NearLanes& near) {
    near.count = 0;
    for (const std::size_t count : near.counts)
        near.count = std::max(near.count, (count + 3) / 4 * 4);
    const std::size_t groups = (used + 3) / 4;
    for (std::size_t lane = 0; lane < 4 * groups; ++lane)
        pad(around[0][lane], around[1][lane], around[2][lane], reach[lane], near.picked[lane], near.counts[lane],
            near.count);
    constexpr std::size_t step = NearLanes::rows * NearLanes::stride, apart = NearLanes::rows * NearLanes::lanes;
    for (std::size_t k = 0; k < near.count; k += 4)
        for (std::size_t row = 0; row < NearLanes::rows; ++row)
            for (std::size_t group = 0; group < groups; ++group)
                turn(near.picked[4 * group][row] + k, step, near.turned[k][row] + 4 * group, apart,
                     group + 1 < groups ? 1 : NearLanes::lanes / 4 - group);
}

} // namespace surface
