// Which places on faces lie in the solid: where closed pieces run into each other or through themselves, a part of the
// faces of each is in the other, and no side of what both enclose (mesh/README 8.3).
//
// How often the closed pieces turn around a place is known in the middles of cells, in which a few faces are; from
// there it is counted along the axes, just outside of the place's face and just inside. With the solid on both sides,
// the place is inside. A piece that is wholly in others and touches none of them stays: it is something of its own that
// was put there.
#pragma once

#include "core/mesh/faces/face_topology.h"

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
    struct Turns {
        int outside = 0, inside = 0; ///< of the face
    };
    bool isSealed(std::uint32_t triangle) const;
    base::Vec3d corner(std::uint32_t triangle, std::size_t k) const;
    base::Vec3d middleOf(std::uint64_t cell) const;
    std::uint64_t cellAt(const base::Vec3d& place) const;
    std::span<const std::uint32_t> trianglesIn(std::size_t cell) const;
    void chooseSize(double area, double edges, std::size_t count);
    void fillCells();
    void countInMiddles();
    void probe();
    bool isOver(const base::Vec3d& place, std::uint32_t triangle, std::size_t axis) const;
    int turnsAt(std::size_t cell, const base::Vec3d& place) const;
    Turns turnsAround(const base::Vec3d& place, std::uint32_t triangle) const;

    const FaceTopology& m_topology;
    std::span<const base::Vec3f> m_positions;
    base::Vec3d m_lo;                                ///< of all sealed bodies
    double m_tolerance = 0, m_size = 0;              ///< the latter of a cell
    std::vector<std::uint64_t> m_cells;              ///< that faces are in, ascending: y, z, x
    std::vector<std::uint32_t> m_first, m_triangles; ///< of each cell
    std::vector<int> m_turns;                        ///< around the middle of each cell
    std::vector<std::uint8_t> m_cut;                 ///< of each body: a part of it is inside
    double m_outerShare = 1;
};

} // namespace mesh
