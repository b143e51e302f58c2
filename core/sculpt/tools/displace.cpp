#include "core/sculpt/tools/displace.h"

#include "core/base/parallel.h"

#include <algorithm>
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

std::vector<BrushBlock> blocksUnder(const tree::SurfelTree& tree, const base::Vec3f& centre, float radius) {
    std::vector<BrushBlock> out;
    tree.forBlocksInBall(centre, radius, [&](std::uint32_t number, const surfel::SurfelBlock& block) {
        out.push_back({number, &block});
    });
    return out;
}

void carry(const surfel::SurfelBlock& block, int cluster, const base::Vec3f& d, const AmountLanes& by,
           surfel::MutableBlockPtr& changed) {
    const float* mask = block.channel(cluster, surfel::Mask);
    alignas(64) float amount[lanes];
    bool moves = false;
    for (std::size_t i = 0; i < lanes; ++i) {
        amount[i] = by.amount[i] * (1 - mask[i]);
        moves |= amount[i] != 0;
    }
    if (!moves)
        return;
    if (!changed)
        changed = block.clone();
    float* x = changed->channel(cluster, surfel::X);
    float* y = changed->channel(cluster, surfel::Y);
    float* z = changed->channel(cluster, surfel::Z);
    float* nx = changed->channel(cluster, surfel::NormalX);
    float* ny = changed->channel(cluster, surfel::NormalY);
    float* nz = changed->channel(cluster, surfel::NormalZ);
    for (std::size_t i = 0; i < lanes; ++i) {
        const float free = 1 - mask[i];
        const float gx = by.gx[i] * free, gy = by.gy[i] * free, gz = by.gz[i] * free;
        // Below 0 the deformation would turn inside out, which only a vertical rim asks for.
        const float stretch = std::max(0.05f, 1 + gx * d.x + gy * d.y + gz * d.z);
        const float tilt = d.x * nx[i] + d.y * ny[i] + d.z * nz[i];
        const float mx = stretch * nx[i] - tilt * gx, my = stretch * ny[i] - tilt * gy,
                    mz = stretch * nz[i] - tilt * gz;
        const float length = std::sqrt(mx * mx + my * my + mz * mz);
        const bool turns = amount[i] != 0 && length > 1e-12f;
        const float scale = 1 / (turns ? length : 1.0f);
        nx[i] = turns ? mx * scale : nx[i], ny[i] = turns ? my * scale : ny[i], nz[i] = turns ? mz * scale : nz[i];
        x[i] = amount[i] != 0 ? x[i] + amount[i] * d.x : x[i];
        y[i] = amount[i] != 0 ? y[i] + amount[i] * d.y : y[i];
        z[i] = amount[i] != 0 ? z[i] + amount[i] * d.z : z[i];
    }
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
