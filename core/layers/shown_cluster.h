// Where the surfels of a cluster are shown: the sum of what their layers hold, at its strengths (layers/README 2).
//
//     P_0 = b,  N_0 = n_b        P_k = P_(k-1) + w_k R_k d_k        M_k = N_(k-1) + w_k R_k e_k,   N_k = M_k / |M_k|
//     w_k = strength (1 - mask_k)              R_k the smallest turn that takes n_b to n_b + g_k (N_(k-1) - n_b)
//     g_k = leaning(|d_k|, h_b): 1 up to a quarter of the support, less and less beyond
//     h = h_b prod max(1/10, 1 + w_k q_k)      and where q_k = 0, times sqrt(max(1, |n_b + w_k e_k| / max(1, |n_b +
//     e_k|)))
//
// A function of the words and the weights alone: the same bits on every machine, whatever came before. A surfel that no
// layer moves has the bits of its base.
#pragma once

#include "core/layers/layer_words.h"

#include <span>

namespace layers {

/// What is displaced so far leans with the surface below by this part of its turn. What leans wholly moves sideways by
/// |d| times the turn, and where normals below differ from surfel to surfel what is long is torn to rags; so beyond
/// `limit` this falls as 2 limit / |d|, with a continuous slope, and nothing moves sideways by more than twice the
/// limit a radian. `far`: |d|.
template <class Real>
Real leaning(Real far, Real limit) {
    return far > limit ? limit * (2 * far - limit) / (far * far) : Real(1);
}
/// The limit, in supports of the base.
constexpr float leanLimit = 0.25f;

struct ShownCluster {
    alignas(64) float position[3][surfel::clusterSize], normal[3][surfel::clusterSize], support[surfel::clusterSize];

    /// Is a surfel shown as it stands in the block?
    bool agrees(const surfel::SurfelBlock& block, int cluster, int lane) const;
    /// Likewise, whatever its support is.
    bool agreesInPlace(const surfel::SurfelBlock& block, int cluster, int lane) const;
    void put(surfel::SurfelBlock& block, int cluster, int lane) const;
};

/// `weights`: of each layer, in the order of `channels.layers`. Lanes past the block's end give no sense.
void show(const surfel::SurfelBlock& block, int cluster, const Channels& channels, std::span<const float> weights,
          ShownCluster& out);

/// The weights of a stack, in its order.
std::vector<float> weightsOf(const Stack& stack);

} // namespace layers
