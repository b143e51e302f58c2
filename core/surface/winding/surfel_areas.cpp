#include "core/surface/winding/surfel_areas.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <bit>
#include <numbers>

namespace surface {

using base::Vec3f;

namespace {

constexpr float reach = 0.8f;            ///< of the support: some 24 neighbours by default
constexpr float fewestNeighbours = 1.5f; ///< their weights' sum; 12 in an even sampling
/// Of the radius: who stands so far above a surfel that faces alike, at 45 degrees or steeper, is of another sheet.
constexpr float above = 0.4f;

/// How much a surfel that faces along `other` lies on the sheet of one that faces along `normal`: wholly up to an edge
/// of 90 degrees, not at all from 120 on.
float sameSheet(const Vec3f& normal, const Vec3f& other) {
    return std::clamp(1 + 2 * dot(normal, other), 0.0f, 1.0f);
}

/// Does one lie in a stack of sheets over the other? As both see it: beyond an edge only one of them looks up steeply.
bool stacked(const Vec3f& way, float distanceSq, const Vec3f& normal, const Vec3f& other, float radiusSq) {
    const float a = dot(way, normal), b = dot(way, other), heightSq = std::min(a * a, b * b);
    return 2 * heightSq > distanceSq && heightSq > above * above * radiusSq;
}

/// Sum of 1 - (distance / radius)^2 over all surfels on the sheet within the radius, its own included.
float crowding(const tree::SurfelTree& tree, const Vec3f& x, const Vec3f& normal, float radius) {
    const float radiusSq = radius * radius;
    float sum = 0;
    tree.forBlocksInBall(x, radius, [&](std::uint32_t, const surfel::SurfelBlock& block) {
        unsigned clusters = block.boundsLanes().within(x, radiusSq) & block.clusterMask();
        for (; clusters != 0; clusters &= clusters - 1) {
            const int begin = std::countr_zero(clusters) * surfel::clusterSize;
            const int end = std::min(block.size(), begin + surfel::clusterSize);
            for (int slot = begin; slot < end; ++slot)
                if (const float d = distanceSq(block.position(slot), x);
                    d < radiusSq && !stacked(block.position(slot) - x, d, normal, block.normal(slot), radiusSq))
                    sum += (1 - d / radiusSq) * sameSheet(normal, block.normal(slot));
        }
    });
    return sum;
}

float areaOf(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, int slot) {
    const float radius = reach * block.support(slot);
    const float sum = crowding(tree, block.position(slot), block.normal(slot), radius);
    return sum < 1 + fewestNeighbours ? 0 : 0.5f * std::numbers::pi_v<float> * radius * radius / sum;
}

void fewAreas(const tree::SurfelTree& tree, const surfel::SurfelBlock& block, float* out) {
    constexpr int looked = 2;
    for (int begin = 0; begin < block.size(); begin += surfel::clusterSize) {
        const int end = std::min(block.size(), begin + surfel::clusterSize), stride = (end - begin + 1) / looked;
        float area = 0, square = 0;
        for (int slot = begin + stride / 2; slot < end; slot += stride) {
            area += areaOf(tree, block, slot);
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
                out[first[from + i] + static_cast<std::size_t>(slot)] = areaOf(tree, block, slot);
        });
    }
    return out;
}

} // namespace surface
