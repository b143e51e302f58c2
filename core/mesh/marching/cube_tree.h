// Cubes that adapt to curvature: where the surface is flat enough, eight cubes merge into one, repeatedly
// (mesh/README 3.11). Internal to the room.
//
// Nothing is evaluated again: a large cube uses the crossings of the fine edges along its own. Cubes merge where
//
//     at most one fine edge crosses along each of the twelve edges    so a vertex has the same name at every size
//     the crossings of each face pair up                              so the surface ends in the finest cubes only
//     no adjacent cube is smaller than half the size                  2:1, across edges and corners too
//     the crossings inside lie close to a plane and face alike
//
// A face between cubes of two sizes is the four small faces for both, so there are no cracks. Small faces and edges
// beside a large cube take part in its loops like its own; the rule for diagonals (fill_loop.h) refers to the six sides
// of the large cube, so the mesh stays manifold.
#pragma once

#include "core/mesh/marching/crossing_moments.h"
#include "core/mesh/marching/cube_loops.h"

namespace mesh {

class CubeTree {
  public:
    /// `tolerance`: roughly how far triangles may be from the surface, in model units. Cubes beside loose ends never
    /// merge, and none become one that `apart` has, by level. REQUIRES: the grid and `apart` outlive the tree.
    CubeTree(const SurfaceGrid& grid, std::span<const LooseEnd> loose, double tolerance,
             std::span<const SparseSet> apart = {});

    static constexpr int mostLevels = 4;
    /// By level: cubes that are not part of a larger one, in units of their side. Level 0 is the grid's own.
    const std::vector<std::vector<GridIndex>>& large() const { return m_large; }
    /// Is the cube above a node part of a larger one?
    bool covered(const GridIndex& place) const;
    /// The loops of a large cube. REQUIRES: level > 0.
    void loopsOf(const GridIndex& place, int level, std::vector<Loop>& out) const;

  private:
    struct Level {
        SparseSet active;                     ///< cubes that the surface passes through
        SparseSet joined;                     ///< those of them that merge
        std::vector<CrossingMoments> moments; ///< of active cubes; not of the grid's own
    };
    bool joins(const GridIndex& place, int level, const CrossingMoments& moments) const;
    bool oneCrossingPerEdge(const GridIndex& place, int level) const;
    bool facesPair(const GridIndex& place, int level) const;
    bool neighboursAreLarge(const GridIndex& place, int level) const;
    bool flat(const CrossingMoments& moments, int level) const;
    void findActive(std::span<const LooseEnd> loose);
    void addLevel(int level);
    bool split(const GridIndex& place, int level) const;
    GridFace face(const GridIndex& place, int level, int axis) const;
    std::uint32_t crossingAlong(const GridIndex& place, int level, int axis, int& count) const;
    template <class Fn>
    void forFaces(const GridIndex& place, int level, int axis, int towards, const Fn& fn) const;

    const SurfaceGrid& m_grid;
    double m_tolerance;
    std::span<const SparseSet> m_apart;
    std::vector<Level> m_levels;
    std::vector<std::vector<GridIndex>> m_large;
};

} // namespace mesh
