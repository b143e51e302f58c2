// Cubes that follow the curvature: where the surface is flat enough, eight cubes become one, and again (alg. 4.4 with
// levels of detail). Internal to the room.
//
// Nothing is evaluated anew: a large cube lives on the crossings of the fine edges along its own. Cubes join where
//
//     at most one fine edge crosses along each of its twelve edges    so a vertex has the same name at every size
//     the crossings of each of its faces pair up                      so the surface ends in the finest cubes only
//     no cube beside it is smaller than half of it                    2:1, also across edges and corners
//     crossings inside lie close to a plane and face alike
//
// A face between cubes of two sizes is the four small faces for both, so there are no cracks. A small face or edge
// beside a large one takes part in the large cube's loops as if it were its own; the rule for diagonals (fill_loop.h)
// speaks of the large cube's six sides, so the mesh stays manifold.
#pragma once

#include "core/mesh/marching/crossing_moments.h"
#include "core/mesh/marching/cube_loops.h"

namespace mesh {

class CubeTree {
  public:
    /// `tolerance`: how far triangles may be from the surface, in model units, about. Cubes beside loose ends stay as
    /// they are.
    CubeTree(const SurfaceGrid& grid, std::span<const LooseEnd> loose, double tolerance);

    static constexpr int mostLevels = 4;
    /// Places of cubes of a level, in units of their side, that are no part of a larger one. Level 0 has the grid's
    /// own.
    const std::vector<std::vector<Place>>& large() const { return m_large; }
    /// Is the cube above a node part of a larger one?
    bool covered(const Place& place) const;
    /// The loops of a large cube. REQUIRES: level > 0.
    void loopsOf(const Place& place, int level, std::vector<Loop>& out) const;

  private:
    struct Level {
        SparseSet active;                     ///< cubes that the surface passes through
        SparseSet joined;                     ///< of them those that may be one
        std::vector<CrossingMoments> moments; ///< of active cubes; not of the grid's own
    };
    bool joins(const Place& place, int level, const CrossingMoments& moments) const;
    bool oneCrossingPerEdge(const Place& place, int level) const;
    bool facesPair(const Place& place, int level) const;
    bool neighboursAreLarge(const Place& place, int level) const;
    bool flat(const CrossingMoments& moments, int level) const;
    void findActive(std::span<const LooseEnd> loose);
    void addLevel(int level);
    bool split(const Place& place, int level) const;
    GridFace face(const Place& place, int level, int axis) const;
    std::uint32_t crossingAlong(const Place& place, int level, int axis, int& count) const;
    template <class Fn>
    void forFaces(const Place& place, int level, int axis, int towards, const Fn& fn) const;

    const SurfaceGrid& m_grid;
    double m_tolerance;
    std::vector<Level> m_levels;
    std::vector<std::vector<Place>> m_large;
};

} // namespace mesh
