// How far the discs of a block stand out over its surface, as those of few samples do where that bends: d^2 / 2 rho
// (render/README 4.4). Where there are cells a disc tells of its own alone, and beside a crease of the one across:
// where that bends, so does the edge.
//
// Lengths are in model units. A worker of one thread, which keeps its memory.
#pragma once

#include "core/cells/labels.h"
#include "core/tree/surfel_tree.h"

namespace render {

class StandOut {
  public:
    /// `radiusOfSupport`: radius of a disc in supports. `model` outlives it.
    StandOut(const tree::SurfelTree& model, float radiusOfSupport);
    /// What the fourth of its discs does: one normal gone wrong tells nothing.
    float of(const surfel::SurfelBlock& block);

  private:
    struct Disc {
        base::Vec3f position, normal, shape;
        std::uint32_t cell = 0;
    };
    Disc discAt(const surfel::SurfelBlock& block, int slot) const;
    void gatherAround(const surfel::SurfelBlock& block);
    std::optional<float> overNeighbours(const Disc& disc, std::span<const Disc> among, float radius);
    std::optional<float> ofAcross(const Disc& disc, std::uint32_t partner, float radius);

    const tree::SurfelTree& m_model;
    float m_radius;
    int m_shape;
    std::optional<cells::LabelLayout> m_labels;
    std::vector<Disc> m_own, m_around; ///< of the block; about it, where that lies beside a crease
    std::vector<float> m_heights;
};

} // namespace render
