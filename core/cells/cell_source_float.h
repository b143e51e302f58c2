// The cells around one place and what the surface of each says there, as CellSource, but with the vectorised sums in
// float32: what rays of pictures ask (cells/README 4.1).
//
//     CellSourcef source(surface);
//     source.setScale(h);                  how large supports are there
//     source.moveTo(x);
//     source.at(i, need)
//
// Space is a lattice of cubes, a power of two between a quarter and a half of the scale wide; places in one cube share
// the surfels packed for it, and what is answered depends on the place and the scale alone, whatever was asked before.
// One thread at a time.
#pragma once

#include "core/cells/cell_clusters.h"
#include "core/cells/cell_source.h"

#include <unordered_map>

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
    /// Of the places to come. The least support near them is right.
    void setScale(double support);
    void moveTo(const base::Vec3d& x);
    const base::Vec3d& position() const { return m_x; }

    /// Cells with surfels in support somewhere near, by ascending label; those without here have no valid value.
    std::size_t count() const { return m_near.size(); }
    std::uint32_t cell(std::size_t i) const { return m_cube->cells()[i].cell; }
    std::size_t find(std::uint32_t cell) const;
    /// Has one cell only surfels in support?
    bool alone();

    Meeting meeting(std::size_t i, std::size_t j);
    std::vector<AbsentCell> absent(std::size_t i);
    double sharpness(std::size_t i, std::size_t j);
    const CellField& at(std::size_t i, surface::Need need);
    CellSource::Tangent tangent(std::size_t i);
    CellSource::Sums sums(std::size_t i) const;
    bool reaches(std::size_t i) const;
    bool smooth(std::size_t i, std::size_t j) {
        return m_cube->cells()[i].face == m_cube->cells()[j].face && meeting(i, j) == Meeting::None;
    }

  private:
    struct Cube {
        int exponent = 0;
        std::int64_t at[3] = {};
        bool operator==(const Cube&) const = default;
    };
    struct CubeHash {
        std::size_t operator()(const Cube& cube) const;
    };
    static base::Box3f boxOf(const Cube& cube);
    const CellSurfels& surfelsAbout(const Cube& cube);

    struct Near {
        bool known = false, counted = false, there = false, beside = false;
        surface::Need need = surface::Need::Value;
        CellField at;
    };

    /// Has cell i surfels in support?
    bool there(std::size_t i);
    void meet();
    /// What cell j adds to the sums of cell i (cells/README 2.2).
    struct Share {
        double v = 0;
        base::Vec3d slope;
    };
    Share shareOf(std::size_t i, std::size_t j);
    surface::ClusterSpan clustersFrom(double share);
    void sumOf(std::size_t i, surface::Need need, CellField& out);
    void layered(surface::Need need, CellField& out);
    surface::Evaluationf evaluate(surface::ClusterSpan clusters, surface::Need need) const;
    double& vote(std::size_t i, std::size_t j) { return m_votes[i * m_near.size() + j]; }

    const CellSurface* m_surface;
    surface::Source m_source;
    surface::SummedNormals m_plain;
    int m_shape; ///< channel of shapes; 0: none
    std::unordered_map<Cube, CellClusters, CubeHash> m_cubes;
    std::unordered_map<Cube, CellSurfels, CubeHash> m_wide; ///< four times as wide: what cubes are packed from
    Cube m_which;
    const CellClusters* m_cube = nullptr;
    int m_exponent = 0;
    base::Vec3d m_x;
    base::Vec3f m_xf;
    std::vector<Near> m_near; ///< as the cube's cells
    bool m_met = false;
    std::vector<double> m_votes; ///< convex > 0, concave < 0, by cell and partner
    std::vector<Share> m_shares, m_steps;
    std::vector<const float*> m_joined;
};

} // namespace cells
