#include "core/surface/winding/surfel_areas.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"

#include <algorithm>
#include <bit>
#include <numbers>

namespace surface {

using base::Vec3f;

namespace {

constexpr float reach = 0.8f;            ///< of the support: some 24 neighbours by default
constexpr float wideReach = 1.2f;        ///< where that is next to nothing: supports of reduced models hold few surfels
constexpr float fewestNeighbours = 1.5f; ///< their weights' sum; 12 in an even sampling
/// Of the radius: who stands so far above a surfel that faces alike, at 45 degrees or steeper, is of another sheet.
constexpr float above = 0.4f;

/// Where one looks from.
struct Place {
    Vec3f x, normal;
    float radiusSq;
};

/// How much normals share, by the cosine between them: as a line, kept between 0 and 1.
struct Facing {
    float at0, slope;
};
constexpr Facing roundEdges{1, 2};       ///< wholly up to 90 degrees, not at all from 120 on
constexpr Facing ofSheet{-7.73f, 8.93f}; ///< 12, 30 degrees

} // namespace

/// What the surfels of a cluster add to the crowding, from its channels, which stand one behind the other: 1 -
/// (distance / radius)^2 within the radius, as much as one faces like the other, and not where one lies in a stack of
/// sheets over the other. As both see it: beyond an edge only one of them looks up steeply.
POINTCLAY_CLONES
static void crowdingInLanes(const float* channels, const Place& at, const Facing& shares, float* out) {
    constexpr int n = surfel::clusterSize;
    const float *px = channels + surfel::X * n, *py = channels + surfel::Y * n, *pz = channels + surfel::Z * n,
                *nx = channels + surfel::NormalX * n, *ny = channels + surfel::NormalY * n,
                *nz = channels + surfel::NormalZ * n;
    const Vec3f from = at.x, normal = at.normal; // not reloaded for fear of what is written
    const float radiusSq = at.radiusSq, steep = above * above * radiusSq, at0 = shares.at0, slope = shares.slope;
    float sums[n];
    for (int k = 0; k < n; ++k) {
        const float x = px[k] - from.x, y = py[k] - from.y, z = pz[k] - from.z;
        const float distanceSq = x * x + y * y + z * z;
        const float a = x * normal.x + y * normal.y + z * normal.z, b = x * nx[k] + y * ny[k] + z * nz[k];
        const float heightSq = b * b < a * a ? b * b : a * a;
        const float facing = at0 + slope * (normal.x * nx[k] + normal.y * ny[k] + normal.z * nz[k]);
        const float alike = facing < 0 ? 0 : 1 < facing ? 1 : facing;
        const float weight = (1 - distanceSq / radiusSq) * alike;
        const float level = heightSq > steep ? (2 * heightSq > distanceSq ? 0.0f : weight) : weight;
        sums[k] = distanceSq < radiusSq ? level : 0.0f;
    }
    std::copy_n(sums, n, out);
}

namespace {

/// The sum over all surfels around, its own included.
float crowding(const tree::SurfelTree& tree, const Place& at, float radius, const Facing& shares) {
    float sum = 0;
    tree.forBlocksInBall(at.x, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        unsigned clusters = block.boundsLanes().within(at.x, at.radiusSq) & block.clusterMask();
        for (; clusters != 0; clusters &= clusters - 1) {
            const int cluster = std::countr_zero(clusters), begin = cluster * surfel::clusterSize;
            float each[surfel::clusterSize];
            crowdingInLanes(block.channel(cluster, surfel::X), at, shares, each);
            for (int k = 0; k < std::min(block.size() - begin, surfel::clusterSize); ++k)
                sum += each[k];
        }
    });
    return sum;
}

float areaOf(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot, const Facing& shares) {
    for (const float part : {reach, wideReach}) {
        const float radius = part * block.support(slot);
        const float sum = crowding(tree, {block.position(slot), block.normal(slot), radius * radius}, radius, shares);
        if (sum >= 1 + fewestNeighbours)
            return 0.5f * std::numbers::pi_v<float> * radius * radius / sum;
    }
    return 0;
}

void fewAreas(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, float* out) {
    constexpr int looked = 2;
    for (int begin = 0; begin < block.size(); begin += surfel::clusterSize) {
        const int end = std::min(block.size(), begin + surfel::clusterSize), stride = (end - begin + 1) / looked;
        float area = 0, square = 0;
        for (int slot = begin + stride / 2; slot < end; slot += stride) {
            area += areaOf(tree, block, slot, roundEdges);
            square += block.support(slot) * block.support(slot);
        }
        for (int slot = begin; slot < end; ++slot)
            out[slot] = block.support(slot) * block.support(slot) * area / square;
    }
}

} // namespace

std::vector<float> surfelAreas(const tree::SurfelTree& tree, const base::Progress& progress, Areas which) {
    constexpr std::size_t blocksAtOnce = 512;
    std::vector<surfel::BlockPtr> blocks;
    std::vector<std::size_t> first;
    std::size_t count = 0;
    tree.forEachBlock([&](std::uint32_t number, const surfel::SurfelBlock& block) {
        blocks.push_back(tree.block(number));
        first.push_back(count);
        count += static_cast<std::size_t>(block.size());
    });
    std::vector<float> out(count);
    for (std::size_t from = 0; from < blocks.size(); from += blocksAtOnce) {
        progress.step(static_cast<double>(from) / static_cast<double>(blocks.size()), "Measuring areas");
        base::parallelFor(std::min(blocksAtOnce, blocks.size() - from), 4, [&](std::size_t i) {
            const surfel::SurfelBlock& block = *blocks[from + i];
            if (which == Areas::Few)
                return fewAreas(tree, block, out.data() + first[from + i]);
            for (int slot = 0; slot < block.size(); ++slot)
                out[first[from + i] + static_cast<std::size_t>(slot)] =
                    areaOf(tree, block, slot, which == Areas::Sheet ? ofSheet : roundEdges);
        });
    }
    return out;
}

} // namespace surface
