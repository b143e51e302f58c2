// Evaluation of a surface at its own surfels, for work on all of a model or of a brush: smoothing, resampling, display
// normals. Several times as fast as evaluating a batch of their positions.
//
//     SelfEvaluator self(surface);                  one per thread; a frozen version and its definition
//     SelfLanes at[surfel::clustersPerBlock];
//     self.evaluate(block, block.clusterMask(), Need::Value, at);
//     ... at[slot / clusterSize].value[slot % clusterSize]
//
// The 16 surfels of a cluster are the lanes; the surfels around them are found once for all and visited one by one. The
// numbers are those of Surface::evaluate at the surfel's position with its own normal as hint, up to rounding: the sums
// run in another order. The same bits at any number of threads and on AVX2 and AVX-512. Surfels that are special (near
// sheets, too few neighbours) and frames other than summed oriented normals take the way of single evaluations.
#pragma once

#include "core/surface/evaluation/candidates.h"
#include "core/surface/evaluation/pick_scratch.h"
#include "core/surface/evaluation/summed_normals.h"

#include <functional>
#include <span>

namespace surface {

/// What an evaluation tells (see Evaluation), for the 16 surfels of a cluster. Lanes past the end hold nothing.
struct SelfLanes {
    static constexpr int lanes = surfel::clusterSize;
    alignas(64) float weight[lanes];
    float value[lanes], unit[lanes], offCentre[lanes], agreement[lanes];
    float centroid[3][lanes], normal[3][lanes];
    float gradient[3][lanes]; ///< where asked for
    float bend[lanes];        ///< e^T (grad n) e with e = x - c, where the kernel is asked for it
    Status status[lanes];

    base::Vec3f centroidAt(int lane) const { return at(centroid, lane); }
    base::Vec3f normalAt(int lane) const { return at(normal, lane); }
    base::Vec3f gradientAt(int lane) const { return at(gradient, lane); }
    /// Takes over what both hold.
    void set(int lane, const Evaluationf& e);

  private:
    static base::Vec3f at(const float (&v)[3][lanes], int lane) { return {v[0][lane], v[1][lane], v[2][lane]}; }
};

/// Evaluates at the surfels of one version's blocks. Used by one thread at a time; keeps the surface alive.
class SelfEvaluator {
  public:
    explicit SelfEvaluator(const Surface& surface) : m_surface(surface), m_plain(m_surface) {}

    /// The clusters of the block named by the bits of `clusters`, each into its place of `out`.
    /// REQUIRES: a block of the surface's tree; need is Value or Gradient; out.size() >= block.clusterCount().
    void evaluate(const surfel::SurfelBlock& block, unsigned clusters, Need need, std::span<SelfLanes> out);

  private:
    void evaluateCluster(const surfel::SurfelBlock& block, int cluster, Need need, SelfLanes& out);
    void evaluateSingly(const surfel::SurfelBlock& block, int cluster, unsigned lanes, Need need, SelfLanes& out) const;

    Surface m_surface;
    SummedNormals m_plain;
    Candidates m_candidates;
    ClusterList m_near;
    PickScratch m_scratch;
};

/// Calls fn(blockNumber, block, evaluations) for the blocks of the given numbers, or all, in parallel. What fn does
/// must not depend on the order.
using SelfFunction = std::function<void(std::uint32_t, const surfel::SurfelBlock&, std::span<const SelfLanes>)>;
void evaluateSelf(const Surface& surface, std::span<const std::uint32_t> blocks, Need need, const SelfFunction& fn);
void evaluateSelf(const Surface& surface, Need need, const SelfFunction& fn);

} // namespace surface
