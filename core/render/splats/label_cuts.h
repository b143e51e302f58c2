// Where discs end at the creases of models with cells (render/README 3.2): on the plane of the patch across, at edges
// that stand out and in grooves. The labels tell which patch that is, whatever the angle.
#pragma once

#include "core/cells/labels.h"
#include "core/render/splats/disc_cuts.h"

#include <span>

namespace render {

/// Finds cuts block by block. A worker of one thread, which keeps its memory.
class LabelCuts {
  public:
    /// `radiusOfSupport`: radius of a disc in supports.
    LabelCuts(const tree::SurfelTree& model, const cells::LabelLayout& labels, float radiusOfSupport)
        : m_model(model), m_labels(labels), m_radius(radiusOfSupport) {}

    /// Cuts those discs of a block that are whole. True if it did.
    bool cut(const surfel::SurfelBlock& block, CutCodes& codes);

  private:
    struct Disc {
        base::Vec3f centre, normal;
        float support = 0, radius = 0;
        cells::Label label;
    };
    /// The line in which the plane of a disc meets that of a patch.
    struct Edge {
        base::Vec3f direction;   ///< unit, along the disc and away from what is kept
        float distance = 0;      ///< from the centre; negative where that lies beyond
        base::Vec3f normal, way; ///< of the patch; from the centre to it
        std::uint32_t cell = 0;
    };

    struct Cluster {
        const surfel::SurfelBlock* block;
        int number;
    };

    void gather(const surfel::SurfelBlock& block);
    bool isFlat() const;
    void gatherBent(const surfel::SurfelBlock& block);
    void gatherAround(const surfel::ClusterBounds& bounds);
    static void keepTurning(std::vector<Disc>& discs, float within);
    void addBends(const Disc& disc, std::vector<Edge>& edges) const;
    std::optional<Edge> edgeTo(std::uint32_t cell, cells::Meeting meeting, const Disc& disc) const;
    static bool reflex(const Edge& a, const Edge& b, cells::Meeting meeting);
    bool turnsAway(const Edge& edge, const Disc& disc) const;
    std::vector<Edge> edgesOf(const Disc& disc) const;
    CutCode cutOf(const Disc& disc) const;

    const tree::SurfelTree& m_model;
    cells::LabelLayout m_labels;
    float m_radius;
    std::vector<Disc> m_near;        ///< beside creases
    std::vector<Cluster> m_clusters; ///< that reach into where bends are looked for
    std::vector<Disc> m_bent;        ///< of cells that bend near the block, cell after cell
    std::vector<Disc> m_around;      ///< of those, what is near a cluster of it
};

} // namespace render
