// A grid whose cubes are of several sizes from the start: small where surfels are dense, large where they are sparse
// (mesh/README 3.16). Internal to the room.
//
// As surface_grid.h, but of cubes that are not halved (cube_levels.h). What counts is the least edge and the least
// face: an edge that a smaller cube has a half of is two edges for all, a face with smaller cubes behind it four. All
// who share one see the same then, and the mesh is as manifold as with cubes of one size. Nodes have the places of the
// lattice's own, so every least edge and face has a name of its own: lowest node and axis.
#pragma once

#include "core/mesh/marching/cube_levels.h"
#include "core/mesh/marching/grid_face.h"

#include <cmath>

namespace mesh {

/// A least edge, from a node of the lattice on.
struct GradedEdge {
    GridIndex node;
    int axis = 0, level = 0;
};

class GradedGrid : public CrossingGrid {
  public:
    GradedGrid(const surface::Surface& surface, const SurfaceTraits& traits, const Lattice& lattice, CubeLevels levels)
        : CrossingGrid(surface, traits, lattice), m_levels(std::move(levels)),
          m_cubes(std::size_t(m_levels.highest()) + 1) {}

    /// Throws base::Cancelled, base::Error where there are more nodes than can be numbered.
    void build(const base::Progress& progress);
    /// Walks edges again in short steps and replaces what is known of them. Returns whether any changed; the grid is
    /// complete afterwards.
    bool reconsider(std::span<const GradedEdge> edges, const base::Progress& progress);

    const CubeLevels& levels() const { return m_levels; }
    /// Those of a level that the surface may pass through.
    const SparseSet& cubes(int level) const { return m_cubes[std::size_t(level)]; }
    /// Calls fn(face) for the least faces of a cube across an axis, below or above it, with their crossings.
    template <class Fn>
    void forFaces(const CubeLevels::Cube& cube, int axis, int above, const Fn& fn) const;
    /// The number that a node has, as of faces with crossings.
    std::uint32_t rankOf(const GridIndex& node) const { return m_nodes.rank(node); }
    using EdgeName = GradedEdge;
    /// The least edges of a least face.
    std::vector<GradedEdge> edgesOf(const GridFace& face) const;

  private:
    static constexpr std::uint32_t unknown = SurfaceGrid::unknown, none = SurfaceGrid::none;
    struct Node {
        NodeSide side;
        bool known = false;
        std::array<std::uint32_t, 3> edges{unknown, unknown, unknown};
    };
    using CubeBits = std::vector<std::vector<BrickBits>>; ///< by level

    CubeBits discs(const base::Progress& progress) const;
    void addDisc(const CubeLevels::Cube& cube, const Disc& disc, CubeBits& out) const;
    void complete(CubeBits cubes, const base::Progress& progress);
    std::vector<CubeLevels::Cube> add(const CubeBits& cubes);
    void addNodes(std::span<const CubeLevels::Cube> cubes);
    void evaluateNodes(const base::Progress& progress);
    std::vector<GradedEdge> openEdges(std::span<const CubeLevels::Cube> cubes);
    /// Those of the edges that cross, which then have numbers.
    std::vector<GradedEdge> walk(std::span<const GradedEdge> edges, Care care, const base::Progress& progress);
    CubeBits cubesAbout(std::span<const GradedEdge> edges) const;
    void number();
    Edge edgeOf(const GradedEdge& edge) const {
        return {m_lattice.at(edge.node), m_lattice.direction(edge.axis), std::ldexp(m_lattice.cell, edge.level)};
    }
    Node& nodeAt(const GridIndex& p) { return m_values[m_nodes.rank(p)]; }
    const Node& nodeAt(const GridIndex& p) const { return m_values[m_nodes.rank(p)]; }
    const NodeSide& endOf(const GradedEdge& edge) const {
        return nodeAt(edge.node.next(edge.axis, 1 << edge.level)).side;
    }
    GridFace leastFace(const GridIndex& place, int axis, int level) const;
    /// fn(edge, side) for the least edges of a face, in order around it. Place and level as of cubes.
    template <class Fn>
    void forSides(const GridIndex& place, int axis, int level, const Fn& fn) const;
    /// fn(edge) for the least edges of a cube.
    template <class Fn>
    void forEdges(const CubeLevels::Cube& cube, const Fn& fn) const;
    template <class Fn>
    void halves(const GridIndex& node, int axis, int level, const Fn& fn) const;

    CubeLevels m_levels;
    std::vector<SparseSet> m_cubes; ///< by level
    SparseSet m_nodes;
    std::vector<Node> m_values;
};

template <class Fn>
void GradedGrid::forFaces(const CubeLevels::Cube& cube, int axis, int above, const Fn& fn) const {
    const GridIndex place = cube.place.next(axis, above);
    if (!m_levels.faceIsQuartered(place, axis, cube.level))
        return fn(leastFace(place, axis, cube.level));
    for (int which = 0; which < 4; ++which)
        fn(leastFace(scaled(place, 1).next((axis + 1) % 3, which & 1).next((axis + 2) % 3, which >> 1), axis,
                     cube.level - 1));
}

} // namespace mesh
