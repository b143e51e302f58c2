// Where discs would stand out past the sharp edges of a model (render/README 3.2): a disc near an edge ends on the
// plane of the side beyond. Only edges that stand out count; in a groove the other side hides what reaches into it.
#pragma once

#include "core/render/splats/disc_cuts.h"

namespace render {

/// Finds cuts cluster by cluster. A worker of one thread, which keeps its memory.
class SharpCuts {
  public:
    /// `radiusOfSupport`: radius of a disc in supports. REQUIRES: the model's normals are those of a surface.
    SharpCuts(const tree::SurfelTree& model, float radiusOfSupport)
        : m_model(model), m_radius(radiusOfSupport), m_oriented(model.layout()->oriented) {}

    /// Cuts those discs of a block that are whole. True if it did.
    bool cut(const surfel::SurfelBlock& block, CutCodes& codes);

  private:
    struct Disc {
        base::Vec3f centre, normal;
        float radius = 0;
    };
    /// Discs, an array for each of their numbers, so that loops over them become vector instructions.
    struct Lanes {
        std::array<std::vector<float>, 7> of; ///< surfel::X to surfel::Support, the last as radius
        std::size_t size = 0;                 ///< in use
        base::Vec3f centre(std::size_t i) const { return {of[0][i], of[1][i], of[2][i]}; }
        base::Vec3f normal(std::size_t i) const { return {of[3][i], of[4][i], of[5][i]}; }
        void makeRoom(std::size_t more) {
            if (size + more > of[0].size())
                for (std::vector<float>& each : of)
                    each.resize(2 * (size + more));
        }
    };
    struct Cluster {
        const surfel::SurfelBlock* block = nullptr;
        int number = 0;
        surfel::ClusterBounds bounds;
    };
    /// A disc beyond an edge; how far off the edge is.
    struct Beyond {
        base::Vec3f way, normal;
        float distance = 0;
    };
    /// Means of the discs beyond that belong to one side.
    struct Side {
        base::Vec3f normal, way;
        std::size_t count = 0;
        bool flat = false;
    };
    template <class Which>
    const Beyond* nearest(const Which& which) const;
    Side sideOf(const base::Vec3f& facing) const;
    bool hasSecondEdge(const base::Vec3f& first, float within) const;
    void gather(const surfel::ClusterBounds& bounds);
    bool mayHaveEdges() const;
    template <bool oriented>
    void findBeyond(const Disc& disc);
    CutCode cutOf(const Disc& disc);

    const tree::SurfelTree& m_model;
    float m_radius;
    bool m_oriented;
    std::vector<Cluster> m_clusters;
    Lanes m_near;
    std::vector<std::uint32_t> m_isBeyond;
    std::vector<Beyond> m_beyond;
};

} // namespace render
