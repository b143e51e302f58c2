// Which links between samples of one face cross a sharp edge (cells/README 1.4, 1.5).
#pragma once

#include "core/base/cells.h"
#include "core/mesh/faces/face_topology.h"

#include <array>
#include <span>

namespace mesh {

/// On which side of an edge between two faces p lies: positive on that of the left triangle.
double sideOf(const FaceTopology& topology, const SharpEdge& edge, const base::Vec3d& p);

/// A sharp edge with the faces beside it.
struct FaceEdge {
    SharpEdge edge;
    std::array<std::uint32_t, 2> faces; ///< on its left and right
};

class EdgeCrossings {
  public:
    /// REQUIRES: links are no longer than 2.2 spacings.
    EdgeCrossings(const FaceTopology& topology, std::span<const FaceEdge> edges, double spacing);

    /// What the way from a to b goes over, of the face's edges.
    struct Crossed {
        int times = 0;                  ///< pieces of one chain, side by side, count once
        const FaceEdge* edge = nullptr; ///< one of them
    };
    Crossed crossed(std::uint32_t face, const base::Vec3d& a, const base::Vec3d& b) const;
    /// fn(place, edge) for places along the edges, at most half a spacing apart.
    template <class Fn>
    void forMarks(const Fn& fn) const {
        for (const FaceEdge& each : m_edges) {
            const std::size_t marks = marksOf(each.edge);
            for (std::size_t k = 0; k <= marks; ++k)
                fn(markOf(each.edge, k, marks), each);
        }
    }

  private:
    std::size_t marksOf(const SharpEdge& edge) const;
    static base::Vec3d markOf(const SharpEdge& edge, std::size_t k, std::size_t marks) {
        return edge.from + (edge.to - edge.from) * (static_cast<double>(k) / static_cast<double>(marks));
    }

    const FaceTopology& m_topology;
    std::span<const FaceEdge> m_edges;
    double m_spacing, m_side; ///< of a grid
    base::CellMap<std::vector<std::uint32_t>> m_grid;
};

} // namespace mesh
