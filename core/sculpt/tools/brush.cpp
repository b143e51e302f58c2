#include "core/sculpt/tools/brush.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"

#include <cmath>

namespace sculpt {

/// Blocks per task: some 20 microseconds of work.
constexpr std::size_t grain = 8;

POINTCLAY_CLONES
static void placeLanes(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& centre, float scale,
                       BrushLanes& out) {
    const float* x = block.channel(cluster, surfel::X);
    const float* y = block.channel(cluster, surfel::Y);
    const float* z = block.channel(cluster, surfel::Z);
    const float cx = centre.x, cy = centre.y, cz = centre.z;
#pragma GCC ivdep
    for (std::size_t i = 0; i < lanes; ++i) {
        out.x[i] = x[i] - cx, out.y[i] = y[i] - cy, out.z[i] = z[i] - cz;
        out.r[i] = std::sqrt(out.x[i] * out.x[i] + out.y[i] * out.y[i] + out.z[i] * out.z[i]) * scale;
    }
}

void Brush::place(const surfel::SurfelBlock& block, int cluster, BrushLanes& out) const {
    placeLanes(block, cluster, centre, 1 / radius, out);
}

/// w'(r)/R u = w'(r)/(r R^2) (p - centre)
POINTCLAY_CLONES
static void overDistance(const float* __restrict r, const float* __restrict slope, float scale, float* __restrict out) {
    for (std::size_t i = 0; i < lanes; ++i) {
        const bool apart = r[i] > 1e-12f;
        const float over = slope[i] / (apart ? r[i] : 1.0f) * scale;
        out[i] = apart ? over : 0.0f;
    }
}

void Brush::fade(const BrushLanes& at, float* weight, float* gradient) const {
    alignas(64) float slope[lanes];
    weights(falloff, plateau, at.r, {weight, lanes}, slope, curve.get());
    overDistance(at.r, slope, 1 / (radius * radius), gradient);
}

bool Brush::weigh(const BrushBlock& in, int cluster, float* weight, bool protect) const {
    BrushLanes at;
    alignas(64) float gradient[lanes];
    place(*in.block, cluster, at);
    fade(at, weight, gradient);
    if (!factors.none())
        factors.multiply(in.number, *in.block, cluster, weight);
    const float* mask = in.block->channel(cluster, surfel::Mask);
    const int used = in.block->size() - cluster * surfel::clusterSize;
    bool any = false;
    for (std::size_t i = 0; i < lanes; ++i) {
        weight[i] *= protect ? 1 - mask[i] : 1.0f;
        weight[i] = static_cast<int>(i) < used ? weight[i] : 0.0f;
        any |= weight[i] != 0;
    }
    return any;
}

std::vector<BrushBlock> blocksUnder(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius) {
    std::vector<BrushBlock> out;
    tree.forBlocksInBall(centre, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        out.push_back({number, &block});
    });
    return out;
}

tree::Edit editOf(const std::vector<BrushBlock>& blocks, std::vector<surfel::BlockPtr> changed) {
    tree::Edit edit;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (changed[i])
            edit.blocks.push_back({blocks[i].number, std::move(changed[i]), {}});
    return edit;
}

/// Asks for the memory of the block whose turn is next.
static void prefetch(const surfel::SurfelBlock& block) {
    const char* begin = reinterpret_cast<const char*>(&block);
    for (std::size_t at = 0; at < block.bytes(); at += 64)
        __builtin_prefetch(begin + at);
}

tree::Edit changeBlocks(const std::vector<BrushBlock>& blocks,
                        const std::function<surfel::BlockPtr(const BrushBlock&, std::size_t)>& make) {
    std::vector<surfel::BlockPtr> changed(blocks.size());
    base::parallelFor(blocks.size(), grain, [&](std::size_t i) {
        if (i + 1 < blocks.size())
            prefetch(*blocks[i + 1].block);
        changed[i] = make(blocks[i], i);
    });
    return editOf(blocks, std::move(changed));
}

} // namespace sculpt
