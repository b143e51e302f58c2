// The cubes near the surface, the values at their nodes and the crossings of their edges (mesh/README 3.1). Internal to
// the room.
//
// The search starts at the surfels: first the cubes that their tangent discs pass through, then, round after round, all
// four cubes about every edge that crosses, until no crossing lacks a cube. So f is evaluated only at corners of cubes
// that the surface passes through, and zeros far from all surfels are never found.
//
// Numbers of nodes and crossings follow the order of bricks (sparse_set.h): the same at any thread count.
#pragma once

#include "core/mesh/marching/crossing_grid.h"
#include "core/mesh/marching/sparse_set.h"

namespace mesh {

class SurfaceGrid : public CrossingGrid {
  public:
    /// Instead of the number of a crossing: edge not visited yet; visited, without a crossing.
    static constexpr std::uint32_t unknown = 0xffffffffu, none = 0xfffffffeu;

    SurfaceGrid(const surface::Surface& surface, const SurfaceTraits& traits, const Lattice& lattice);

    /// Throws base::Cancelled, base::Error where there are more nodes than can be numbered.
    void build(const base::Progress& progress);

    const SparseSet& nodes() const { return m_nodes; }
    const NodeValue& value(std::uint32_t node) const { return m_values[node]; }
    /// Of the edge from a node along an axis: a number below `none` if it crosses.
    std::uint32_t crossingOf(std::uint32_t node, int axis) const { return m_edges[3 * std::size_t(node) + axis]; }

    /// Walks edges again in short steps and replaces what is known of them. Returns whether any changed; the grid is
    /// complete afterwards.
    struct EdgeName {
        GridIndex node;
        int axis = 0;
    };
    static std::array<EdgeName, 4> edgesOf(const struct GridFace& face);
    bool reconsider(std::span<const EdgeName> edges, const base::Progress& progress);

  private:
    struct Job {
        GridIndex node;
        std::uint32_t first = 0, last = 0; ///< ranks of its ends
        int axis = 0;
    };
    std::vector<BrickBits> discs(const base::Progress& progress) const;
    void complete(std::vector<BrickBits> cubes, const base::Progress& progress);
    void add(std::vector<BrickBits> cubes);
    void evaluateNodes(const base::Progress& progress);
    std::vector<Job> openEdges();
    struct Found {
        std::size_t job = 0;
        Crossing crossing;
    };
    Edge edgeOf(const GridIndex& node, int axis) const {
        return {m_lattice.at(node), m_lattice.direction(axis), m_lattice.cell};
    }
    std::vector<Found> walk(std::span<const Job> jobs, Care care, const base::Progress& progress) const;
    std::vector<Job> take(std::span<const Job> jobs, std::span<const Found> found);
    std::vector<BrickBits> cubesAbout(std::span<const Job> jobs) const;
    void number();

    NodeSide sideOf(std::uint32_t node) const { return {m_values[node], m_solid ? m_sides[node] : SolidSide::Untold}; }

    SparseSet m_nodes;
    std::vector<NodeValue> m_values;
    std::vector<std::uint8_t> m_known; ///< is the value of the node there?
    std::vector<SolidSide> m_sides;    ///< of the nodes, where there are any
    std::vector<std::uint32_t> m_edges;
};

} // namespace mesh
