// What layers hold at a place of a version, between its surfels (layers/README 4): a moving least squares fit,
// quadratic along the surface, to the nearest surfels that face alike, with weights that grow towards them, so that a
// surfel that stays gets its own. Internal to this room.
#pragma once

#include "core/layers/surfel_layers.h"

#include <array>

namespace layers {

class Inheritance {
  public:
    static constexpr std::size_t terms = 6; ///< of a quadratic in the plane

    /// Of `tree`, which outlives this. Nothing is inherited where `known` is false.
    Inheritance(const tree::SurfelTree& tree, const Channels& channels, bool known = true)
        : m_tree(tree), m_channels(channels), m_known(known) {}

    /// Parts and normal of the base for a surfel that stands there; no displacement where that is not on the version's
    /// surface.
    void at(const SurfelLayers::Shown& place, SurfelLayers& out);

  private:
    bool gather(const SurfelLayers::Shown& place);
    void weigh(const SurfelLayers::Shown& place);

    const tree::SurfelTree& m_tree;
    Channels m_channels;
    bool m_known;
    struct Row {
        std::array<double, terms> phi;
        double weight;
    };
    std::vector<tree::Neighbour> m_near;
    std::vector<Row> m_rows;       ///< of m_near
    std::vector<double> m_weights; ///< of m_near; their sum is 1
    SurfelLayers m_one;
};

} // namespace layers
