#include "core/sculpt/tools/brush.h"

#include "core/base/parallel.h"

#include <cmath>

namespace sculpt {

/// Blocks per task: some 20 microseconds of work.
constexpr std::size_t grain = 8;

void Brush::place(const surfel::SurfelBlock& block, int cluster, BrushLanes& out) const {
    const float* x = block.channel(cluster, surfel::X);
    const float* y = block.channel(cluster, surfel::Y);
    const float* z = block.channel(cluster, surfel::Z);
    const float scale = 1 / radius;
    for (std::size_t i = 0; i < lanes; ++i) {
        out.x[i] = x[i] - centre.x, out.y[i] = y[i] - centre.y, out.z[i] = z[i] - centre.z;
        out.r[i] = std::sqrt(out.x[i] * out.x[i] + out.y[i] * out.y[i] + out.z[i] * out.z[i]) * scale;
    }
}

void Brush::fade(const BrushLanes& at, float* weight, float* gradient) const {
    alignas(64) float slope[lanes];
    weights(falloff, plateau, at.r, {weight, lanes}, slope, curve.get());
    const float scale = 1 / (radius * radius); // w'(r)/R u = w'(r)/(r R^2) (p - centre)
    for (std::size_t i = 0; i < lanes; ++i)
        gradient[i] = at.r[i] > 1e-12f ? slope[i] / at.r[i] * scale : 0.0f;
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

tree::Edit changeBlocks(const std::vector<BrushBlock>& blocks,
                        const std::function<surfel::BlockPtr(const BrushBlock&, std::size_t)>& make) {
    std::vector<surfel::BlockPtr> changed(blocks.size());
    base::parallelFor(blocks.size(), grain, [&](std::size_t i) { changed[i] = make(blocks[i], i); });
    tree::Edit edit;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (changed[i])
            edit.blocks.push_back({blocks[i].number, std::move(changed[i]), {}});
    return edit;
}

} // namespace sculpt
