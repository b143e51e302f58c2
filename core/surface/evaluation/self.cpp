#include "core/surface/evaluation/self.h"

#include "core/base/parallel.h"
#include "core/surface/evaluation/kernels/self_kernel.h"
#include "core/surface/evaluation/near_sheets.h"

#include <bit>
#include <cassert>

namespace surface {

constexpr std::size_t blocksPerTask = 8;
/// Surfels that come this close to a limit of the assembler's are left to it.
constexpr float clearly = 1.001f;

void SelfLanes::set(int lane, const Evaluationf& e) {
    weight[lane] = e.weight;
    value[lane] = e.value;
    unit[lane] = e.unit;
    offCentre[lane] = e.offCentre;
    agreement[lane] = e.agreement;
    for (int k = 0; k < 3; ++k) {
        const std::size_t axis = static_cast<std::size_t>(k);
        centroid[k][lane] = e.centroid[axis];
        normal[k][lane] = e.normal[axis];
        gradient[k][lane] = e.gradient[axis];
    }
    status[lane] = e.status;
}

void SelfEvaluator::evaluate(const surfel::SurfelBlock& block, unsigned clusters, Need need, std::span<SelfLanes> out) {
    assert(need != Need::Hessian && out.size() >= static_cast<std::size_t>(block.clusterCount()));
    base::Box3f box;
    for (unsigned left = clusters; left != 0; left &= left - 1)
        box.extend(block.bounds(std::countr_zero(left)).box);
    if (m_plain.applies())
        m_candidates.collect(m_surface, box);
    for (unsigned left = clusters; left != 0; left &= left - 1) {
        const int cluster = std::countr_zero(left);
        evaluateCluster(block, cluster, need, out[static_cast<std::size_t>(cluster)]);
    }
}

void SelfEvaluator::evaluateCluster(const surfel::SurfelBlock& block, int cluster, Need need, SelfLanes& out) {
    const int count = std::min(surfel::clusterSize, block.size() - cluster * surfel::clusterSize);
    const unsigned used = (1u << count) - 1;
    if (!m_plain.applies())
        return evaluateSingly(block, cluster, used, need, out);
    const base::Box3f box = block.bounds(cluster).box;
    m_near.clear();
    m_candidates.select(box, m_near);
    float* scratch = m_scratch.rows(selfRows(m_plain.shape() > 0), m_near.size());
    const SelfInput in{block.channel(cluster, surfel::X),
                       box,
                       m_near.span(),
                       m_plain.weight(),
                       m_plain.supportScale(),
                       m_plain.mu(),
                       m_plain.boundaryLimit(),
                       clearly * static_cast<float>(oneSheetBelow),
                       clearly * static_cast<float>(leastSpread),
                       need == Need::Gradient,
                       false,
                       m_plain.shape()};
    const unsigned special = selfKernel(in, scratch, out) & used;
    for (int lane = 0; lane < count; ++lane)
        out.status[lane] = m_plain.settled(out.status[lane], block.position(cluster * surfel::clusterSize + lane));
    if (special)
        evaluateSingly(block, cluster, special, need, out);
}

void SelfEvaluator::evaluateSingly(const surfel::SurfelBlock& block, int cluster, unsigned lanes, Need need,
                                   SelfLanes& out) const {
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes), slot = cluster * surfel::clusterSize + lane;
        out.set(lane, m_surface.evaluate(block.position(slot), need, {block.normal(slot)}));
    }
}

void evaluateSelf(const Surface& surface, std::span<const std::uint32_t> blocks, Need need, const SelfFunction& fn) {
    base::parallelChunks(blocks.size(), blocksPerTask, [&](std::size_t begin, std::size_t end, std::size_t) {
        SelfEvaluator self(surface);
        SelfLanes at[surfel::clustersPerBlock];
        for (const std::uint32_t number : blocks.subspan(begin, end - begin)) {
            const surfel::BlockPtr block = surface.tree().block(number);
            self.evaluate(*block, block->clusterMask(), need, at);
            fn(number, *block, {at, static_cast<std::size_t>(block->clusterCount())});
        }
    });
}

void evaluateSelf(const Surface& surface, Need need, const SelfFunction& fn) {
    std::vector<std::uint32_t> all(surface.tree().blockCount());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<std::uint32_t>(i);
    evaluateSelf(surface, all, need, fn);
}

} // namespace surface
