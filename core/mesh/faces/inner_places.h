// Which places on faces lie in the solid: where closed pieces run into each other or through themselves, a part of the
// faces of each is in the other, and no side of what both enclose (mesh/README 8.3).
//
// How often the closed pieces turn around a place is counted just outside of the place's face and just inside. With the
// solid on both sides, the place is inside. A piece that is wholly in others and touches none of them is something of
// its own that was put there, and stays; but not where these others run into each other: in what they are together,
// nobody put anything.
#pragma once

#include "core/mesh/faces/winding_cells.h"

namespace mesh {

class InnerPlaces {
  public:
    /// Both must outlive this. Time: that of a sort of some cells for each triangle; none where no piece is closed.
    /// Throws base::Cancelled.
    InnerPlaces(const FaceTopology& topology, std::span<const base::Vec3f> positions);

    /// Of the faces' area, what is not inside.
    double outerShare() const { return m_outerShare; }
    /// For a place on a triangle. Safe for threads.
    bool has(const base::Vec3d& place, std::uint32_t triangle) const;

  private:
    enum class Depth : std::uint8_t {
        Outside, ///< or wholly inside of something that it was put into
        Cut,     ///< a part of it is inside
        Buried   ///< all of it is
    };
    struct Probe {
        base::Vec3d place;
        std::uint32_t triangle;
        double weight; ///< area that it stands for
        WindingCells::Turns turns;
    };
    std::vector<std::uint32_t> sealedTriangles() const;
    std::vector<Probe> probes() const;
    void judge();
    bool isBuried(std::span<const Probe> all, const std::vector<std::uint32_t>& firstProbes, std::uint32_t body) const;

    const FaceTopology& m_topology;
    std::span<const base::Vec3f> m_positions;
    std::vector<std::uint32_t> m_sealed; ///< triangles of bodies without holes
    WindingCells m_cells;
    std::vector<Depth> m_depths; ///< of each body
    double m_outerShare = 1;
};

} // namespace mesh
