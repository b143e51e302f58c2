// The cells around one place and what the surface of each says there, as CellSource, but with the vectorised sums in
// float32: what rays of pictures ask (cells/README 4.1).
//
//     CellSourcef source(surface);
//     source.setScale(h);                  how large supports are there: a hint
//     source.moveTo(x);
//     source.at(i, need)
//
// Positions that come close to the one before find their surfels among those collected around it; what is answered
// depends on the place alone, whatever was asked before. One thread at a time.
#pragma once

#include "core/cells/cell_source.h"

namespace cells {

/// What rays need of an evaluation.
struct CellField {
    surface::Status status = surface::Status::Outside;
    double weight = 0, value = 0, offCentre = 0, unit = 0, agreement = 0;
    base::Vec3d centroid, normal, gradient;
};
inline bool valid(const CellField& at) {
    return at.status == surface::Status::Ok || at.status == surface::Status::BeyondBoundary;
}

class CellSourcef {
  public:
    static constexpr std::size_t none = CellSource::none;
    static constexpr double settled = 1e-4;   ///< of the support: the error is some square of the last step
    static constexpr double precision = 2e-6; ///< of the support: to which zeros are bracketed
    static constexpr double noise = 1e-5;     ///< of the support: two values are equal
    static constexpr double rounding = static_cast<double>(std::numeric_limits<float>::epsilon()); ///< of a coordinate

    explicit CellSourcef(const CellSurface& surface);

    const CellSurface& surface() const { return *m_surface; }
    /// Of the places to come: how far around them surfels are collected.
    void setScale(double support) { m_scale = static_cast<float>(support); }
    void moveTo(const base::Vec3d& x);
    const base::Vec3d& position() const { return m_x; }

    /// Cells with surfels in support, by ascending label.
    std::size_t count() const { return m_near.size(); }
    std::uint32_t cell(std::size_t i) const { return m_near[i].cell; }
    std::size_t find(std::uint32_t cell) const;
    /// Has one cell only surfels in support?
    bool alone() const { return count() == 1; }

    Meeting meeting(std::size_t i, std::size_t j) {
        if (!m_met)
            meet();
        if (vote(i, j) == 0 && !m_near[i].beside)
            return Meeting::None;
        const double convex = vote(i, j) + vote(j, i);
        return convex > 0 ? Meeting::Convex : convex < 0 ? Meeting::Concave : Meeting::None;
    }
    std::vector<AbsentCell> absent(std::size_t i);
    double sharpness(std::size_t i, std::size_t j) { return meeting(i, j) == Meeting::None ? 0 : 1 - shareOf(i, j).v; }
    const CellField& at(std::size_t i, surface::Need need);
    CellSource::Tangent tangent(std::size_t i);
    CellSource::Sums sums(std::size_t i) const;
    bool reaches(std::size_t i) const;
    bool smooth(std::size_t i, std::size_t j) {
        return m_near[i].face == m_near[j].face && meeting(i, j) == Meeting::None;
    }

  private:
    /// A part with surfels in support, and which they are.
    struct Found {
        const CellPart* part;
        unsigned lanes;
    };
    struct Near {
        std::uint32_t cell = 0, face = 0;
        std::uint32_t begin = 0, end = 0; ///< among the parts found
        bool known = false, joined = false, beside = false;
        surface::Need need = surface::Need::Value;
        CellField at;
    };

    void collect();
    void gather();
    std::span<const Found> partsOf(std::size_t i) const {
        return std::span(m_found).subspan(m_near[i].begin, m_near[i].end - m_near[i].begin);
    }
    surface::ClusterSpan clustersOf(std::size_t i) const {
        return surface::ClusterSpan(m_clusters).subspan(m_near[i].begin, m_near[i].end - m_near[i].begin);
    }
    void meet();
    double votes(std::size_t i, std::uint32_t partner) const;
    /// What cell j adds to the sums of cell i (cells/README 2.2).
    struct Share {
        double v = 0;
        base::Vec3d slope;
    };
    Share shareOf(std::size_t i, std::size_t j);
    Share fadedShare(std::size_t i, std::size_t j); ///< of cells that meet
    surface::ClusterSpan clustersFrom(double share);
    void sumOf(std::size_t i, surface::Need need, CellField& out);
    void layered(surface::Need need, CellField& out);
    surface::Evaluationf evaluate(surface::ClusterSpan clusters, surface::Need need) const;
    double& vote(std::size_t i, std::size_t j) { return m_votes[i * m_near.size() + j]; }

    const CellSurface* m_surface;
    surface::Source m_source;
    surface::SummedNormals m_plain;
    int m_shape; ///< channel of shapes; 0: none
    float m_scale = 0;
    base::Vec3d m_x;
    base::Vec3f m_xf;
    base::Box3f m_box;                    ///< positions in it need no other parts than these
    std::vector<const CellPart*> m_about; ///< by cell, each in the order of the tree
    std::vector<const float*> m_aboutChannels;
    std::vector<std::uint16_t> m_lanes; ///< of these parts, in support
    std::vector<Found> m_found;
    std::vector<const float*> m_clusters; ///< of the parts found
    std::vector<Near> m_near;
    bool m_met = false;
    std::vector<double> m_votes;      ///< convex > 0, concave < 0, by cell and partner
    std::vector<std::uint8_t> m_said; ///< likewise: are there surfels that say convex (1), concave (2)?
    static constexpr double unknown = -1;
    std::vector<Share> m_shares, m_steps;
    std::vector<Share> m_faded; ///< of pairs that meet, once somebody has asked
    std::vector<const float*> m_joined, m_fades;
};

} // namespace cells
