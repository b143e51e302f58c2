// How often closed pieces of faces turn around a place, counted over cells of an octree (mesh/README 8.3).
//
// Cells are halved where many faces are, wherever that is: a thousand boxes in one spot of a large scene have small
// ones. The number is known at a place by chance in each cell; from there it is counted along a straight way through
// the few faces in it. Faces nearer to each other than coordinates tell are on top of each other: how near that is
// follows the faces in the cell, not the whole.
#pragma once

#include "core/base/vec.h"
#include "core/mesh/faces/face_topology.h"

namespace mesh {

class WindingCells {
  public:
    /// All must outlive this; `sealed`: those triangles that count. Throws base::Cancelled.
    WindingCells(const FaceTopology& topology, std::span<const base::Vec3f> positions,
                 const std::vector<std::uint32_t>& sealed);

    struct Turns {
        int outside = 0, inside = 0; ///< of a face
    };
    /// Just before and just behind a place on a triangle, past what lies on top of it. Safe for threads.
    Turns turnsAround(const base::Vec3d& place, std::uint32_t triangle) const;
    /// Whether there is something on both sides: at once where all of a cell is in something.
    bool isInside(const base::Vec3d& place, std::uint32_t triangle) const;

    /// The bodies that hold the place, ascending; it lies on `own`, which does not count. Time: that of a line through
    /// all cells.
    std::vector<std::uint32_t> bodiesAround(const base::Vec3d& place, std::uint32_t own) const;

  private:
    struct Cell {
        base::Vec3d lo, place;            ///< the corner; somewhere in it
        double size = 0, onTop = 0;       ///< the latter: how near faces in it may be to each other
        std::uint32_t children = 0;       ///< the first of eight; 0: none
        std::uint32_t first = 0, end = 0; ///< its triangles, where it has no children, by bodies
        int turns = 0;                    ///< around `place`; of bodies without faces in it alone while it is halved
        bool solid = false;               ///< all of it is inside of something
    };
    /// Of a body with faces in a cell, around the cell's place.
    struct BodyTurns {
        std::uint32_t body;
        int turns;
    };
    struct Halved;
    void findHoles();
    void halve(Halved& out, const Cell& cell, std::span<const std::uint32_t> triangles,
               std::span<const BodyTurns> bodies) const;
    base::Vec3d corner(std::uint32_t triangle, std::size_t k) const;
    double onTop(std::uint32_t triangle) const;
    bool meets(std::uint32_t triangle, const Cell& cell) const;
    void halveAll();
    std::uint32_t cellAt(const base::Vec3d& place) const;
    bool isOver(const base::Vec3d& place, std::uint32_t triangle, std::size_t axis) const;
    int turnsBetween(std::span<const std::uint32_t> triangles, const base::Vec3d& from, const base::Vec3d& to) const;

    const FaceTopology& m_topology;
    std::span<const base::Vec3f> m_positions;
    std::vector<Cell> m_cells; ///< each before its children
    std::vector<std::uint32_t> m_triangles;
    std::vector<std::uint8_t> m_holes; ///< of each body: it encloses what is not
};

} // namespace mesh
