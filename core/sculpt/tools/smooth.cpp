#include "core/sculpt/tools/smooth.h"

#include "core/base/clones.h"
#include "core/base/parallel.h"
#include "core/sculpt/own_cells.h"
#include "core/sculpt/tools/brush.h"
#include "core/surface/evaluation/self.h"

#include <bit>
#include <cmath>

namespace sculpt {

namespace {

/// Blocks per task, which share one evaluator.
constexpr std::size_t grain = 8;
/// Flattest gradient that tells a direction, squared.
constexpr float flattestSq = 0.01f;
/// A step of more than the spacing comes from a fold, where f is no distance: of h.
constexpr float longest = 0.25f;

/// Shares of a block's surfels, 0 for what stays, and the clusters in which any is not 0.
struct Shares {
    alignas(64) float of[surfel::blockCapacity];
    unsigned clusters = 0;

    Shares(const Brush& brush, const BrushBlock& in, float strength) {
        for (int cluster = 0; cluster < in.block->clusterCount(); ++cluster) {
            float* share = of + cluster * surfel::clusterSize;
            if (!brush.reaches(*in.block, cluster) || !brush.weigh(in, cluster, share))
                continue;
            for (std::size_t i = 0; i < lanes; ++i)
                share[i] *= strength;
            clusters |= 1u << cluster;
        }
    }
    const float* ofCluster(int cluster) const { return of + cluster * surfel::clusterSize; }
};

/// Takes the share from surfels where there is no surface to go to. Returns whether any is left.
bool leaveOut(const surface::SelfLanes& e, const float* share, float* left) {
    bool any = false;
    for (std::size_t i = 0; i < lanes; ++i) {
        const bool there = e.status[i] == surface::Status::Ok || e.status[i] == surface::Status::BeyondBoundary;
        left[i] = there ? share[i] : 0.0f;
        const float sq = e.gradient[0][i] * e.gradient[0][i] + e.gradient[1][i] * e.gradient[1][i] +
                         e.gradient[2][i] * e.gradient[2][i];
        left[i] = sq > flattestSq ? left[i] : 0.0f;
        any |= left[i] != 0;
    }
    return any;
}

/// Draws a cluster to the surface.
POINTCLAY_CLONES
void settle(surfel::SurfelBlock& block, int cluster, const float* share, const surface::SelfLanes& e) {
    float* x = block.channel(cluster, surfel::X);
    float* y = block.channel(cluster, surfel::Y);
    float* z = block.channel(cluster, surfel::Z);
    float* nx = block.channel(cluster, surfel::NormalX);
    float* ny = block.channel(cluster, surfel::NormalY);
    float* nz = block.channel(cluster, surfel::NormalZ);
#pragma GCC ivdep
    for (std::size_t i = 0; i < lanes; ++i) {
        const float t = share[i];
        const bool moves = t != 0;
        float gx = e.gradient[0][i], gy = e.gradient[1][i], gz = e.gradient[2][i];
        const float slope = std::sqrt(gx * gx + gy * gy + gz * gz), scale = 1 / (moves ? slope : 1.0f);
        gx *= scale, gy *= scale, gz *= scale;
        const float limit = longest * e.unit[i], full = e.value[i] * scale;
        const float step = t * (full > limit ? limit : full < -limit ? -limit : full);
        x[i] = moves ? x[i] - gx * step : x[i];
        y[i] = moves ? y[i] - gy * step : y[i];
        z[i] = moves ? z[i] - gz * step : z[i];
        const float side = gx * nx[i] + gy * ny[i] + gz * nz[i] < 0 ? -t : t, stay = 1 - t;
        const float mx = nx[i] * stay + gx * side, my = ny[i] * stay + gy * side, mz = nz[i] * stay + gz * side;
        const float length = std::sqrt(mx * mx + my * my + mz * mz);
        const bool known = nx[i] != 0 || ny[i] != 0 || nz[i] != 0, turns = moves && known && length > 0;
        const float unit = 1 / (turns ? length : 1.0f);
        nx[i] = turns ? mx * unit : nx[i], ny[i] = turns ? my * unit : ny[i], nz[i] = turns ? mz * unit : nz[i];
    }
}

/// The block after the dab; null where nothing moves.
surfel::BlockPtr smoothed(const Brush& brush, const BrushBlock& in, float strength, surface::SelfEvaluator& self,
                          OwnCells::Evaluator& own) {
    const Shares shares(brush, in, strength);
    if (shares.clusters == 0)
        return {};
    surface::SelfLanes at[surfel::clustersPerBlock];
    self.evaluate(*in.block, shares.clusters, surface::Need::Gradient, at);
    own.replace(in, shares.clusters, at);
    surfel::MutableBlockPtr changed;
    for (unsigned left = shares.clusters; left != 0; left &= left - 1) {
        const int cluster = std::countr_zero(left);
        const surface::SelfLanes& e = at[cluster];
        alignas(64) float share[lanes];
        if (!leaveOut(e, shares.ofCluster(cluster), share))
            continue;
        if (!changed)
            changed = in.block->clone();
        settle(*changed, cluster, share, e);
    }
    if (changed)
        changed->seal();
    return changed;
}

} // namespace

static tree::Edit smooth(const surface::Surface& version, const Dab& dab) {
    const Brush brush(dab);
    const float strength = std::abs(dab.strength);
    if (strength == 0)
        return {};
    surface::SurfaceDefinition definition = version.definition();
    definition.shrinkFree = true;
    const surface::Surface ground(version.tree(), definition);
    const std::vector<BrushBlock> blocks = blocksUnder(version.tree(), brush.centre, brush.radius);
    const OwnCells own(ground, blocks);
    std::vector<surfel::BlockPtr> changed(blocks.size());
    base::parallelChunks(blocks.size(), grain, [&](std::size_t begin, std::size_t end, std::size_t) {
        surface::SelfEvaluator self(ground);
        OwnCells::Evaluator alone(own);
        for (std::size_t i = begin; i < end; ++i)
            changed[i] = smoothed(brush, blocks[i], strength, self, alone);
    });
    return editOf(blocks, std::move(changed));
}

const ToolRow smoothTool{"smooth",
                         "Smooth",
                         "icons/tool-smooth.svg",
                         "S",
                         "Evens out relief under the brush and keeps the shape's size.",
                         Motion::Along,
                         0.5,
                         {},
                         smooth};

} // namespace sculpt
